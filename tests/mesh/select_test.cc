// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Picking, turning and adding triangles with all that they carry.

#include <rigor/mesh/select.h>

#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/bodies.h"

namespace rigor::mesh {
namespace {

Corners::Texture texture_at(const Vector3& p) {
  return {static_cast<float>(2 * p.x + p.y), static_cast<float>(p.z - p.x)};
}

Corners::Color color_at(const Vector3& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z), 1};
}

Corners::Normal normal_of(const Facet& f) {
  const Vector3 n = cross(f[1] - f[0], f[2] - f[0]);
  const double size = length(n);
  return {static_cast<float>(n.x / size), static_cast<float>(n.y / size),
          static_cast<float>(n.z / size)};
}

/// A box whose corners carry linear functions of their places, in three parts of two materials.
TriangleMesh dressed_box() {
  TriangleMesh mesh = box_mesh({2, 2, 2});
  for (const Triangle& t : mesh.triangles) {
    const Facet f = facet(mesh, t);
    mesh.corners.texture.push_back({texture_at(f[0]), texture_at(f[1]), texture_at(f[2])});
    mesh.corners.colors.push_back({color_at(f[0]), color_at(f[1]), color_at(f[2])});
    mesh.corners.normals.push_back({normal_of(f), normal_of(f), normal_of(f)});
  }
  mesh.parts = {{"floor", "wood", 0, 2}, {"roof", "tin", 2, 2}, {"walls", "wood", 4, 8}};
  mesh.materials = {{"wood"}, {"tin"}};
  return mesh;
}

void expect_dressed(const TriangleMesh& mesh) {
  ASSERT_EQ(mesh.corners.texture.size(), mesh.triangles.size());
  ASSERT_EQ(mesh.corners.normals.size(), mesh.triangles.size());
  ASSERT_EQ(mesh.corners.colors.size(), mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Facet f = facet(mesh, mesh.triangles[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(mesh.corners.texture[i][k], texture_at(f[k])) << i;
      EXPECT_EQ(mesh.corners.colors[i][k], color_at(f[k])) << i;
      EXPECT_EQ(mesh.corners.normals[i][k], normal_of(f)) << i;
    }
  }
}

TEST(Select, KeepsWhatTheTrianglesCarry) {
  const TriangleMesh kept = selected(dressed_box(), {1, 4, 5, 11});
  expect_dressed(kept);
  ASSERT_EQ(kept.triangles.size(), 4U);
  EXPECT_EQ(kept.triangles[1], dressed_box().triangles[4]);
  ASSERT_EQ(kept.parts.size(), 2U);  // the roof has none left
  EXPECT_EQ(kept.parts[0].name, "floor");
  EXPECT_EQ(kept.parts[0].count, 1U);
  EXPECT_EQ(kept.parts[1].name, "walls");
  EXPECT_EQ(kept.parts[1].first, 1U);
  EXPECT_EQ(kept.parts[1].count, 3U);
  EXPECT_EQ(kept.materials.size(), 2U);
}

TEST(Select, AllIsTheMeshItselfAndNoneIsEmpty) {
  std::vector<std::uint32_t> all(12);
  std::iota(all.begin(), all.end(), 0U);
  const TriangleMesh same = selected(dressed_box(), all);
  EXPECT_EQ(same.triangles, dressed_box().triangles);
  EXPECT_EQ(same.parts.size(), 3U);
  const TriangleMesh none = selected(dressed_box(), {});
  EXPECT_TRUE(none.triangles.empty() && none.parts.empty() && none.corners.texture.empty());
}

TEST(Select, TurnedOverTwiceIsAsBefore) {
  TriangleMesh mesh = dressed_box();
  turn_over(mesh, 3);
  EXPECT_EQ(mesh.triangles[3][1], dressed_box().triangles[3][2]);
  expect_dressed(mesh);  // the normals turned with the triangle
  turn_over(mesh, 3);
  EXPECT_EQ(mesh.triangles, dressed_box().triangles);
  expect_dressed(mesh);
}

TEST(Select, APieceCarriesWhatItsPlaceHas) {
  TriangleMesh mesh = dressed_box();
  const Triangle t = mesh.triangles[2];
  const Facet f = facet(mesh, t);
  mesh.positions.push_back(0.5 * (f[0] + f[1]));
  mesh.positions.push_back(0.25 * f[0] + 0.25 * f[1] + 0.5 * f[2]);
  append_piece(mesh, {8, t[1], t[2]}, 2);
  append_piece(mesh, {8, 9, t[0]}, 2);
  append_piece(mesh, {9, 8, t[0]}, 2);  // faces the other side, and so do its normals
  expect_dressed(mesh);
  EXPECT_EQ(mesh.parts.back().material, "tin");
  EXPECT_EQ(mesh.parts.back().first, 12U);
  EXPECT_EQ(mesh.parts.back().count, 3U);
}

TEST(Select, AnAddedTriangleTakesTheNearestOfItsNeighbor) {
  TriangleMesh mesh = dressed_box();
  const Triangle t = mesh.triangles[0];
  const Facet f = facet(mesh, t);
  mesh.positions.push_back(f[0] + (f[0] - f[1]) + (f[0] - f[2]));  // beyond the first corner
  append(mesh, {8, t[1], t[0]}, 0);
  EXPECT_EQ(mesh.corners.texture.back()[0], texture_at(f[0]));
  EXPECT_EQ(mesh.corners.texture.back()[1], texture_at(f[1]));
  EXPECT_EQ(mesh.corners.colors.back()[2], color_at(f[0]));
  EXPECT_EQ(mesh.corners.normals.back()[0], Corners::Normal{});
  EXPECT_EQ(mesh.parts.size(), 3U);  // the walls are of wood as well
  EXPECT_EQ(mesh.parts.back().count, 9U);
}

TEST(Select, BesideATriangleOfNoAreaNothingIsLost) {
  TriangleMesh mesh = dressed_box();
  mesh.triangles[0] = {3, 3, 3};
  append(mesh, {0, 1, 2}, 0);
  for (const Corners::Texture& uv : mesh.corners.texture.back()) {
    EXPECT_TRUE(std::isfinite(uv[0]) && std::isfinite(uv[1]));
  }
}

TEST(Select, CompactWeldsAndForgetsWhatIsNotUsed) {
  TriangleMesh mesh = dressed_box();
  mesh.positions.push_back({7, 7, 7});
  mesh.positions.push_back(mesh.positions[0]);
  for (std::uint32_t& corner : mesh.triangles[0]) corner = corner == 0 ? 9 : corner;
  compact(mesh);
  EXPECT_EQ(mesh.positions.size(), 8U);
  expect_dressed(mesh);
  EXPECT_TRUE(topology_of(mesh).closed());
}

}  // namespace
}  // namespace rigor::mesh
