// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Normals against shapes that have them in closed form.

#include <rigor/mesh/normals.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace rigor::mesh {
namespace {

using test::box_mesh;
using test::torus_mesh;
using Normal = Corners::Normal;

constexpr double kHalfTurn = 3.14159265358979323846;
constexpr double kRightAngle = kHalfTurn / 2;
constexpr double kAlmost = 1e-6;  // 32-bit numbers of size 1

void expect_normal(const Normal& is, const Vector3& wanted, double tolerance) {
  EXPECT_LE(length(as_vector(is) - wanted), tolerance) << is[0] << ' ' << is[1] << ' ' << is[2];
}

TEST(Normals, FlatOnesAreTheFaces) {
  const TriangleMesh mesh = recomputed_normals(box_mesh({1, 2, 3}), kFlat);
  ASSERT_EQ(mesh.corners.normals.size(), 12U);
  EXPECT_EQ(mesh.corners.normals[0], (std::array<Normal, 3>{{{0, 0, -1}, {0, 0, -1}, {0, 0, -1}}}));
  for (std::size_t i = 0; i < 12; ++i) {
    const auto [a, b, c] = facet(mesh, mesh.triangles[i]);
    const Vector3 out = cross(b - a, c - a);
    for (const Normal& n : mesh.corners.normals[i]) {
      expect_normal(n, (1 / length(out)) * out, kAlmost);
    }
  }
}

/// At a box's corner three right angles meet, whichever way its faces are cut into triangles.
TEST(Normals, SmoothOnesAreWeightedByAngle) {
  const TriangleMesh mesh = recomputed_normals(box_mesh({1, 2, 3}), kHalfTurn);
  for (std::size_t i = 0; i < 12; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Vector3& p = mesh.positions[mesh.triangles[i][c]];
      const Vector3 out{std::copysign(1, p.x), std::copysign(1, p.y), std::copysign(1, p.z)};
      expect_normal(mesh.corners.normals[i][c], (1 / std::sqrt(3.0)) * out, kAlmost);
    }
  }
}

TEST(Normals, EdgesSharperThanTheCreaseStaySharp) {
  const TriangleMesh box = box_mesh({1, 1, 1});
  const auto flat = recomputed_normals(box, kFlat).corners.normals;
  EXPECT_EQ(recomputed_normals(box, kRightAngle - 0.01).corners.normals, flat);
  EXPECT_NE(recomputed_normals(box, kRightAngle + 0.01).corners.normals, flat);
}

TEST(Normals, PositionsOfEqualPlacesAreOne) {
  TriangleMesh soup = box_mesh({1, 2, 3});
  std::vector<Vector3> positions;
  for (Triangle& t : soup.triangles) {
    for (std::uint32_t& corner : t) {
      positions.push_back(soup.positions[corner]);
      corner = static_cast<std::uint32_t>(positions.size() - 1);
    }
  }
  soup.positions = positions;
  EXPECT_EQ(recomputed_normals(soup, kHalfTurn).corners.normals,
            recomputed_normals(box_mesh({1, 2, 3}), kHalfTurn).corners.normals);
}

/// Of a fine torus they are within the square of a cell's angle of the true ones.
TEST(Normals, ATorusIsSmooth) {
  constexpr unsigned kCells = 100;
  constexpr double kCell = 2 * kHalfTurn / kCells;
  const TriangleMesh mesh = recomputed_normals(torus_mesh(3, 1, kCells, kCells), 0.5);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Vector3& p = mesh.positions[mesh.triangles[i][c]];
      const double far = std::hypot(p.x, p.y);
      const Vector3 ring{3 * p.x / far, 3 * p.y / far, 0};
      expect_normal(mesh.corners.normals[i][c], p - ring, kCell * kCell);
    }
  }
}

/// Two cones that touch at their tips share a place, but no edge.
TEST(Normals, WhatOnlyTouchesStaysApart) {
  const TriangleMesh mesh{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0.5}},
                          .triangles = {{0, 1, 2}, {0, 3, 4}}};
  EXPECT_EQ(recomputed_normals(mesh, kHalfTurn).corners.normals,
            recomputed_normals(mesh, kFlat).corners.normals);
}

TEST(Normals, WithoutAreaThereIsNone) {
  const TriangleMesh mesh{.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}},
                          .triangles = {{0, 1, 2}, {0, 2, 3}, {1, 1, 1}}};
  const auto normals = recomputed_normals(mesh, kHalfTurn).corners.normals;
  EXPECT_EQ(normals[0], (std::array<Normal, 3>{}));
  EXPECT_EQ(normals[1][0], (Normal{0, 0, 1}));
  EXPECT_EQ(normals[2], (std::array<Normal, 3>{}));
  EXPECT_TRUE(recomputed_normals({}, kHalfTurn).corners.normals.empty());
}

TEST(Normals, LengthOneStaysAsItIs) {
  std::mt19937 random(1);
  std::normal_distribution<double> any;
  for (int round = 0; round < 10'000; ++round) {
    const Vector3 v{any(random), any(random), any(random)};
    const Normal once = normal_along(v);
    EXPECT_EQ(normal_along(as_vector(once)), once);
    EXPECT_NEAR(length(as_vector(once)), 1, 1.1e-7);
    expect_normal(once, (1 / length(v)) * v, kAlmost);
  }
  EXPECT_EQ(normal_along({}), Normal{});
  EXPECT_EQ(normal_along({0, std::nan(""), 1}), Normal{});
  EXPECT_EQ(normal_along({0, 0, HUGE_VAL}), Normal{});
  EXPECT_EQ(normal_along({0, 0, -1e-300}), (Normal{0, 0, -1}));
}

}  // namespace
}  // namespace rigor::mesh
