// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include <rigor/convert/mjcf/mesh_solid.h>
#include <rigor/mesh/primitive/primitive_mesh.h>

namespace rigor::test {
namespace {

using convert::mujoco_solid;
using convert::MujocoSolid;
using convert::MujocoUse;

/// The volume, by the divergence theorem about the origin.
double volume_about_origin(const mesh::TriangleMesh& mesh) {
  double six = 0;
  for (const mesh::Triangle& t : mesh.triangles) {
    const mesh::Facet f = mesh::facet(mesh, t);
    six += dot(f[0], cross(f[1], f[2]));
  }
  return six / 6;
}

mesh::TriangleMesh square() {
  mesh::TriangleMesh mesh;
  mesh.positions = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 2}};  // the second one looks down
  return mesh;
}

TEST(MjcfMesh, ConvexMeshStaysAsItIs) {
  const MujocoSolid box = mujoco_solid(mesh::mesh_of(mesh::Box{{1, 2, 3}}), MujocoUse::kCollision);
  ASSERT_TRUE(box.mesh);
  EXPECT_FALSE(box.replaced);
  EXPECT_EQ(box.change, "");
}

TEST(MjcfMesh, InsideOutCollisionBecomesItsHull) {
  mesh::TriangleMesh box = mesh::mesh_of(mesh::Box{{1, 2, 3}});
  for (mesh::Triangle& t : box.triangles) std::swap(t[0], t[1]);
  const MujocoSolid solid = mujoco_solid(box, MujocoUse::kCollision);
  ASSERT_TRUE(solid.mesh);
  EXPECT_TRUE(solid.replaced);
  EXPECT_NEAR(volume_about_origin(*solid.mesh), 6, 1e-12);
}

/// Two boxes of 1 m³, 1 m apart along x: their hull has 3 m³.
TEST(MjcfMesh, ConcaveCollisionIsToldWithItsShare) {
  mesh::TriangleMesh both = mesh::mesh_of(mesh::Box{{1, 1, 1}});
  const mesh::TriangleMesh other = both;
  const auto count = static_cast<std::uint32_t>(both.positions.size());
  for (const mesh::Vector3& p : other.positions) both.positions.push_back({p.x + 2, p.y, p.z});
  for (const mesh::Triangle& t : other.triangles) {
    both.triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
  }
  const MujocoSolid solid = mujoco_solid(both, MujocoUse::kCollision);
  EXPECT_FALSE(solid.replaced);
  EXPECT_NE(solid.change.find("1.5 times"), std::string::npos) << solid.change;
}

TEST(MjcfMesh, FlatVisualGetsABackAndFlatCollisionIsNone) {
  const MujocoSolid visual = mujoco_solid(square(), MujocoUse::kVisual);
  ASSERT_TRUE(visual.mesh);
  EXPECT_EQ(visual.mesh->triangles.size(), 4U);
  // The front encloses 1/3 · 1 m · 1 m² with the origin, its back that much less what it is thick.
  EXPECT_GT(std::abs(volume_about_origin(*visual.mesh)), 1e-5);
  EXPECT_FALSE(mujoco_solid(square(), MujocoUse::kCollision).mesh);
}

}  // namespace
}  // namespace rigor::test
