// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Simpler shapes in the place of a mesh: what is chosen for bodies of known shape, and that the bound is kept.

#include <rigor/mesh/substitute/substitute.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <rigor/mesh/primitive/primitive_mesh.h>
#include <rigor/mesh/reduce.h>
#include <rigor/mesh/spatial/distance.h>
#include <rigor/mesh/substitute/fitted.h>

#include "support/meshes.h"

namespace rigor::mesh {
namespace {

TriangleMesh shifted_by(TriangleMesh mesh, const Vector3& by) {
  for (Vector3& p : mesh.positions) p = p + by;
  return mesh;
}

double surface_of(const TriangleMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) sum += rigor::mesh::area(facet(mesh, t));
  return sum;
}

/// A prism on an outline of the plane that is wound counter-clockwise and seen whole from its first corner.
TriangleMesh upright_prism(const std::vector<Vector3>& outline, double height) {
  TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(outline.size());
  for (const double z : {0.0, height}) {
    for (const Vector3& p : outline) mesh.positions.push_back({p.x, p.y, z});
  }
  for (std::uint32_t i = 1; i + 1 < n; ++i) {
    mesh.triangles.push_back({0, i + 1, i});
    mesh.triangles.push_back({n, n + i, n + i + 1});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t k = (i + 1) % n;
    mesh.triangles.push_back({i, k, n + k});
    mesh.triangles.push_back({i, n + k, n + i});
  }
  return mesh;
}

TEST(Substitute, ABallIsASphere) {
  const auto found =
      find_substitute(test::faceted_ball(0.2), {.max_error = 0.02, .capsules = Capsules::kRefused});
  ASSERT_TRUE(found && found->primitive);
  const auto* sphere = std::get_if<Sphere>(&found->primitive->shape);
  ASSERT_NE(sphere, nullptr);
  EXPECT_NEAR(sphere->radius, 0.2, 1e-6);
  EXPECT_EQ(found->triangles, 0U);
  EXPECT_LE(found->hausdorff, 0.02);
  // The mesh of a ball is inside of it.
  EXPECT_GT(found->volume_error, 0);
  EXPECT_LT(found->volume_error, 0.1);
  EXPECT_FALSE(found->of_hull);
}

TEST(Substitute, ABoxIsABoxWithoutError) {
  const auto found = find_substitute(mesh_of(Box{{1, 2, 3}}), {.max_error = 0.01});
  ASSERT_TRUE(found && found->primitive);
  EXPECT_TRUE(std::holds_alternative<Box>(found->primitive->shape));
  EXPECT_NEAR(found->hausdorff, 0, 1e-12);
  EXPECT_NEAR(found->volume_error, 0, 1e-12);
}

TEST(Substitute, CapsulesCanBeRefused) {
  TriangleMesh capsule = test::faceted_ball(0.1);
  for (Vector3& p : capsule.positions) p.z += p.z > 1e-9 ? 0.25 : p.z < -1e-9 ? -0.25 : 0;
  const auto found = find_substitute(capsule, {.max_error = 0.01});
  ASSERT_TRUE(found && found->primitive);
  EXPECT_TRUE(std::holds_alternative<Capsule>(found->primitive->shape));
  const auto other = find_substitute(capsule, {.max_error = 0.01, .capsules = Capsules::kRefused});
  EXPECT_FALSE(other && other->primitive);
}

/// A half of a ball is no primitive, but convex.
TEST(Substitute, AConvexBodyIsItsHull) {
  TriangleMesh half = test::faceted_ball(0.2);
  for (Vector3& p : half.positions) p.z = std::max(p.z, 0.0);
  const auto found = find_substitute(half, {.max_error = 0.004});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, SubstituteKind::kHull);
  EXPECT_LE(found->hausdorff, 0.004);
  EXPECT_LT(found->triangles, half.triangles.size());
  ASSERT_EQ(found->meshes.size(), 1U);
  EXPECT_LE(deviation(half, found->meshes[0], 20'000).hausdorff(), 0.004 * 1.01);
}

TEST(Substitute, AnAngleIsTwoPieces) {
  // 18 triangles are fewer than those of two boxes: the arms are cut finely.
  TriangleMesh angle = upright_prism(
      {{0, 0, 0}, {1, 0, 0}, {1, 0.2, 0}, {0.2, 0.2, 0}, {0.2, 1, 0}, {0, 1, 0}}, 0.3);
  for (int round = 0; round < 1; ++round) {
    TriangleMesh finer;
    for (const Triangle& t : angle.triangles) {
      const Facet f = facet(angle, t);
      const Vector3 ab = 0.5 * (f[0] + f[1]), bc = 0.5 * (f[1] + f[2]), ca = 0.5 * (f[2] + f[0]);
      for (const Facet& part :
           {Facet{f[0], ab, ca}, Facet{ab, f[1], bc}, Facet{ca, bc, f[2]}, Facet{ab, bc, ca}}) {
        const auto first = static_cast<std::uint32_t>(finer.positions.size());
        finer.positions.insert(finer.positions.end(), part.begin(), part.end());
        finer.triangles.push_back({first, first + 1, first + 2});
      }
    }
    angle = std::move(finer);
  }
  const auto found = find_substitute(angle, {.max_error = 0.02});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, SubstituteKind::kPieces);
  EXPECT_LE(found->hausdorff, 0.02);
  EXPECT_NEAR(found->volume_error, 0, 0.02);
  EXPECT_GE(found->meshes.size(), 2U);
}

/// A sheet of separate tiles, on a parabola: no two share an edge that could be collapsed.
TEST(Substitute, TilesThatDoNotHangTogether) {
  TriangleMesh tiles;
  constexpr int kTiles = 24;
  const auto corner = [](double i, double j) {
    const double x = i / kTiles, y = j / kTiles;
    return Vector3{x, y, x * x};
  };
  for (int i = 0; i < kTiles; ++i) {
    for (int j = 0; j < kTiles; ++j) {
      constexpr double kGap = 0.05;
      const auto first = static_cast<std::uint32_t>(tiles.positions.size());
      for (const auto& [di, dj] : {std::pair(kGap, kGap), std::pair(1 - kGap, kGap),
                                   std::pair(1 - kGap, 1 - kGap), std::pair(kGap, 1 - kGap)})
        tiles.positions.push_back(corner(i + di, j + dj));
      tiles.triangles.push_back({first, first + 1, first + 2});
      tiles.triangles.push_back({first, first + 2, first + 3});
    }
  }
  const auto found = find_substitute(tiles, {.max_error = 0.04});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, SubstituteKind::kReduced);
  EXPECT_LE(5 * found->triangles, tiles.triangles.size());
  ASSERT_EQ(found->meshes.size(), 1U);
  EXPECT_LE(deviation(tiles, found->meshes[0], 20'000).hausdorff(), 0.04 * 1.01);
}

/// Corners on a ball have all of the surface inside of it; with corners outside, half of the distance would do.
TEST(Fitted, CornersBesideASurfaceBringItNearer) {
  const TriangleMesh ball = test::faceted_ball(1);
  const TriangleMesh coarse = reduce(ball, {.triangles = 40}).mesh;
  const TriangleMesh near = fitted(coarse, ball);
  EXPECT_EQ(near.triangles, coarse.triangles);
  EXPECT_LT(deviation(near, ball, 10'000).hausdorff(),
            0.65 * deviation(coarse, ball, 10'000).hausdorff());
  // What is there already stays.
  EXPECT_NEAR(deviation(fitted(ball, ball), ball, 1000).hausdorff(), 0, 1e-12);
}

TEST(Substitute, ABoundThatNothingKeepsGivesNothing) {
  const TriangleMesh ball = test::faceted_ball(0.2);
  EXPECT_FALSE(find_substitute(ball, {.max_error = 1e-9}));
  EXPECT_FALSE(find_substitute(ball, {.max_error = 0}));
  EXPECT_FALSE(find_substitute({}, {.max_error = 1}));
}

/// Two cubes side by side: 10 faces, with the two that touch left out.
TEST(OuterSkin, LeavesOutWherePiecesMeet) {
  const TriangleMesh cube = mesh_of(Box{{1, 1, 1}});
  EXPECT_NEAR(surface_of(outer_skin({cube}, 0.1)), 6, 1e-9);
  EXPECT_NEAR(surface_of(outer_skin({cube, shifted_by(cube, {1, 0, 0})}, 0.1)), 10, 1e-9);
  // Half of one in the other: a box of 1.5 by 1 by 1, whose sides both pieces have where they overlap.
  const TriangleMesh skin = outer_skin({cube, shifted_by(cube, {0.5, 0, 0})}, 0.1);
  EXPECT_NEAR(surface_of(skin), 8 + 4 * 0.5, 1e-9);
  const TriangleMesh whole = shifted_by(mesh_of(Box{{1.5, 1, 1}}), {0.25, 0, 0});
  EXPECT_NEAR(deviation(whole, skin, 10'000).hausdorff(), 0, 1e-9);
}

}  // namespace
}  // namespace rigor::mesh
