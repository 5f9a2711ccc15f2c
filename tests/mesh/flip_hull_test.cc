// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Hulls of meshes that are nearly their own, beside those of qhull, and whether meshes are convex.

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <rigor/mesh/convex/convexity.h>
#include <rigor/mesh/convex/flip_hull.h>
#include <rigor/mesh/convex/hull.h>
#include <rigor/mesh/primitive/principal_axes.h>
#include <rigor/mesh/spatial/predicate.h>
#include <rigor/mesh/topology/edge_balance.h>

#include "support/meshes.h"

namespace rigor::mesh {
namespace {

using test::box_mesh;
using test::joined;
using test::torus_mesh;
using test::turned;

double to_float(double x) { return double{static_cast<float>(x)}; }

/// A globe of coordinates that are rounded as an STL rounds them: its flat quads then bend either way.
TriangleMesh globe(unsigned rows, unsigned columns, const Vector3& size) {
  constexpr double kPi = 3.141592653589793;
  TriangleMesh mesh{.positions = {{0, 0, to_float(size.z)}}};
  for (unsigned i = 1; i < rows; ++i) {
    for (unsigned j = 0; j < columns; ++j) {
      const double u = kPi * i / rows;
      const double v = 2 * kPi * j / columns;
      mesh.positions.push_back({to_float(size.x * std::sin(u) * std::cos(v)),
                                to_float(size.y * std::sin(u) * std::sin(v)),
                                to_float(size.z * std::cos(u))});
    }
  }
  mesh.positions.push_back({0, 0, to_float(-size.z)});
  const auto at = [columns](unsigned i, unsigned j) { return 1 + (i - 1) * columns + j % columns; };
  const auto last = static_cast<std::uint32_t>(mesh.positions.size() - 1);
  for (unsigned j = 0; j < columns; ++j) {
    mesh.triangles.push_back({0, at(1, j), at(1, j + 1)});
    mesh.triangles.push_back({last, at(rows - 1, j + 1), at(rows - 1, j)});
    for (unsigned i = 1; i + 1 < rows; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

/// What a hull is: closed, with no point above any of its triangles, and of the volume that qhull
/// finds.
void expect_hull_of(const TriangleMesh& mesh, const TriangleMesh& hull) {
  EdgeBalance balance;
  for (const Triangle& t : hull.triangles) {
    balance.add(facet(hull, t));
    for (const Vector3& p : mesh.positions) EXPECT_LE(side(facet(hull, t), p), 0);
  }
  EXPECT_TRUE(balance.closed());
  const auto other = convex_hull(mesh.positions);
  ASSERT_TRUE(other);
  EXPECT_NEAR(enclosed_volume(hull) / enclosed_volume(*other), 1, 1e-12);
}

TEST(FlipHull, ABoxIsItsOwn) {
  const TriangleMesh box = box_mesh({1, 2, 3});
  const auto hull = flip_hull(box);
  ASSERT_TRUE(hull);
  EXPECT_EQ(hull->triangles, box.triangles);
}

TEST(FlipHull, RoundedGlobes) {
  for (const Vector3& size : {Vector3{1, 1, 1}, Vector3{1, 2, 0.3}, Vector3{1e-3, 1e-3, 5}}) {
    const TriangleMesh mesh = globe(24, 40, size);
    const auto hull = flip_hull(mesh);
    ASSERT_TRUE(hull);
    EXPECT_NE(hull->triangles, mesh.triangles) << "else this test is of no use";
    expect_hull_of(mesh, *hull);
  }
}

/// Vertices are moved inward by up to a tenth: what comes is the hull, or nothing.
TEST(FlipHull, DentsAreFilled) {
  std::mt19937 random(7);
  int made = 0;
  for (unsigned round = 0; round < 200; ++round) {
    TriangleMesh mesh = globe(5 + round % 7, 6 + round % 5, {1, 1.5, 0.7});
    const auto share = [&random] { return static_cast<double>(random() % 1000) / 1000; };
    const double depth = 0.1 * share();
    for (Vector3& p : mesh.positions) p = (1 - depth * share()) * p;
    const auto hull = flip_hull(mesh);
    if (!hull) continue;
    ++made;
    expect_hull_of(mesh, *hull);
  }
  EXPECT_GT(made, 50);
}

/// A box whose sides are grids, turned so that their coordinates are rounded.
TEST(FlipHull, VerticesInsideSidesAreLeftOut) {
  std::mt19937 random(8);
  int left_out = 0;
  for (int round = 0; round < 20; ++round) {
    TriangleMesh mesh;
    const auto add_side = [&mesh](int axis, double end) {
      constexpr std::uint32_t kCells = 6;
      const auto base = static_cast<std::uint32_t>(mesh.positions.size());
      for (std::uint32_t i = 0; i <= kCells; ++i) {
        for (std::uint32_t j = 0; j <= kCells; ++j) {
          const double u = 2.0 * i / kCells - 1;
          const double v = 2.0 * j / kCells - 1;
          mesh.positions.push_back(axis == 0   ? Vector3{end, u, v}
                                   : axis == 1 ? Vector3{v, end, u}
                                               : Vector3{u, v, end});
        }
      }
      for (std::uint32_t i = 0; i < kCells; ++i) {
        for (std::uint32_t j = 0; j < kCells; ++j) {
          const std::uint32_t a = base + i * (kCells + 1) + j;
          const std::uint32_t b = a + kCells + 1;
          Triangle lower{a, b, b + 1};
          Triangle upper{a, b + 1, a + 1};
          if (end < 0) std::swap(lower[1], lower[2]);
          if (end < 0) std::swap(upper[1], upper[2]);
          mesh.triangles.push_back(lower);
          mesh.triangles.push_back(upper);
        }
      }
    };
    for (const int axis : {0, 1, 2}) {
      for (const double end : {-1.0, 1.0}) add_side(axis, end);
    }
    const model::Quaternion turn = model::from_axis_angle(
        {1 + double(random() % 9), double(random() % 9), 2}, 0.1 + double(random() % 60) / 10);
    for (Vector3& p : mesh.positions) {
      p = rotate(turn, p);
      p = {to_float(p.x), to_float(p.y), to_float(p.z)};
    }
    const auto hull = flip_hull(mesh);
    if (!hull) continue;
    expect_hull_of(mesh, *hull);
    left_out += hull->triangles.size() < mesh.triangles.size() ? 1 : 0;
  }
  EXPECT_GT(left_out, 5);
}

TEST(FlipHull, WhatIsNotClosedOrSeenOnceHasNone) {
  const TriangleMesh box = box_mesh({1, 2, 3});
  TriangleMesh open = box;
  open.triangles.pop_back();
  TriangleMesh flipped = box;
  std::swap(flipped.triangles[5][0], flipped.triangles[5][1]);
  TriangleMesh endless = box;
  endless.positions[0].x = std::nan("");
  const TriangleMesh sheet{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                           .triangles = {{0, 1, 2}, {0, 2, 1}}};
  for (const TriangleMesh& mesh :
       {TriangleMesh{}, open, flipped, endless, sheet, turned(box), torus_mesh(0.2, 0.06, 40, 24),
        joined(box, box), joined(box, box_mesh({1, 1, 1}, {5, 0, 0})),
        joined(box, box_mesh({2, 3, 4}))}) {
    EXPECT_FALSE(flip_hull(mesh));
  }
}

/// Searching round a vertex of 100,000 triangles for each of them would never end.
TEST(FlipHull, VerticesOfManyTrianglesAreBounded) {
  EXPECT_FALSE(flip_hull(globe(3, 100'000, {1, 1, 1})));
}

TEST(Convexity, BodiesWithAndWithoutDents) {
  const auto convex = [](const TriangleMesh& mesh) {
    return is_convex(mesh, enclosed_volume(mesh));
  };
  EXPECT_TRUE(convex(box_mesh({1, 2, 3})));
  EXPECT_TRUE(convex(globe(40, 60, {1, 2, 3})));
  EXPECT_FALSE(convex(torus_mesh(0.2, 0.06, 40, 24)));
  EXPECT_FALSE(convex({}));
  // One vertex of 2,342 moved inward: the dent is a 2,000th of the volume.
  TriangleMesh dented = globe(40, 60, {1, 2, 3});
  dented.positions[1000] = 0.5 * dented.positions[1000];
  EXPECT_FALSE(convex(dented));
  // A vertex moved outward leaves its neighbors below the hull.
  TriangleMesh thorn = globe(40, 60, {1, 2, 3});
  thorn.positions[1000] = 1.5 * thorn.positions[1000];
  EXPECT_FALSE(convex(thorn));
}

}  // namespace
}  // namespace rigor::mesh
