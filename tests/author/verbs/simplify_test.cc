// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// simplify-collisions: what stands in the file afterwards, and what is left as it is.

#include <rigor/author/verbs/simplify/simplify.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include <rigor/mesh/primitive/primitive_mesh.h>
#include <rigor/mesh/read.h>
#include <rigor/mesh/write/write.h>

#include "author/verbs/verb_bench.h"
#include "support/meshes.h"

namespace rigor::author {
namespace {

mesh::TriangleMesh moved_ball(mesh::TriangleMesh mesh, const mesh::Vector3& by) {
  for (mesh::Vector3& p : mesh.positions) p = p + by;
  return mesh;
}

std::string ball_stl() { return mesh::write_stl(moved_ball(test::faceted_ball(100), {0, 0, 500})); }
std::string half_ball_stl() {
  mesh::TriangleMesh half = test::faceted_ball(1);
  for (mesh::Vector3& p : half.positions) p.z = std::max(p.z, 0.0);
  return mesh::write_stl(half);
}

TEST(Simplify, AUrdfsMeshesInMillimeters) {
  constexpr const char* kUrdf = R"(<robot name="r">
  <link name="a">
    <inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision>
      <origin xyz="1 0 0" rpy="0 0 0"/>
      <!-- a ball -->
      <geometry><mesh filename="ball.stl" scale="0.001 0.001 0.001"/></geometry>
    </collision>
  </link>
</robot>
)";
  VerbBench bench({{"r.urdf", kUrdf}, {"ball.stl", ball_stl()}});
  const EditedModel& r = bench.open("r.urdf");
  const Change change = simplified(r, {});
  const std::string text = bench.text(r, change);
  EXPECT_NE(text.find("<!-- a ball -->\n      <geometry><sphere radius=\"0.1\"/></geometry>"),
            std::string::npos)
      << text;
  const ProvenChange proven = bench.prove(r, change);
  const robot::Part& part = proven.after->robot.bodies[0].collisions[0];
  EXPECT_NEAR(part.X_BS.translation.x, 1, 1e-6);
  EXPECT_NEAR(part.X_BS.translation.z, 0.5, 1e-6);
  EXPECT_EQ(proven.after->robot.bodies[0].mass, r.robot.bodies[0].mass);
  EXPECT_TRUE(change.new_files.empty());
}

TEST(Simplify, ASdfHullBesideItsMesh) {
  constexpr const char* kSdf = R"(<sdf version="1.7">
  <model name="m">
    <link name="a">
      <collision name="c">
        <geometry><mesh><uri>model://m/meshes/dome.stl</uri><scale>-1 1 2</scale></mesh></geometry>
        <surface><contact><ode><kp>5</kp></ode></contact></surface>
      </collision>
    </link>
  </model>
</sdf>
)";
  VerbBench bench(
      {{"m/model.sdf", kSdf},
       {"m/model.config", "<model><name>m</name><sdf version=\"1.7\">model.sdf</sdf></model>"},
       {"m/meshes/dome.stl", half_ball_stl()},
       {"m/meshes/dome_hull.stl", "another file"}});
  const EditedModel& m = bench.open("m/model.sdf");
  const Change change = simplified(m, {});
  std::string expected = kSdf;
  expected.replace(expected.find("dome.stl"), 8, "dome_hull_2.stl");
  EXPECT_EQ(bench.text(m, change), expected);
  ASSERT_EQ(change.new_files.size(), 1U);
  EXPECT_EQ(change.new_files[0].path, "m/meshes/dome_hull_2.stl");
  // In the old file's coordinates: a half ball of radius 1.
  VerbBench second({{"m.stl", change.new_files[0].bytes}});
  const mesh::LoadedMesh hull = mesh::read_mesh(second.environment().disk, "m.stl");
  const mesh::Bounds bounds = mesh::bounds_of(hull.mesh.positions);
  EXPECT_NEAR(bounds.max.z, 1, 0.04);
  EXPECT_NEAR(bounds.min.x, -1, 0.04);
  EXPECT_NEAR(bounds.min.z, 0, 0.01);  // corners may lie beside the old surface
}

TEST(Simplify, FromVisuals) {
  constexpr const char* kSdf = R"(<sdf version="1.6">
  <model name="m">
    <link name="a">
      <visual name="v">
        <geometry><mesh><uri>ball.stl</uri></mesh></geometry>
      </visual>
    </link>
  </model>
</sdf>
)";
  VerbBench bench({{"m.sdf", kSdf}, {"ball.stl", ball_stl()}});
  const EditedModel& m = bench.open("m.sdf");
  EXPECT_NE(simplified(m, {}).refused, "");
  const std::string text =
      bench.text(m, simplified(m, {.missing = MissingCollisions::kFromVisuals}));
  EXPECT_NE(text.find(R"(      <collision name="v">
        <pose>)"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find(R"(            <radius>100</radius>)"), std::string::npos) << text;
}

TEST(Simplify, WhatIsLeftIsNamedWithItsReason) {
  constexpr const char* kUrdf = R"(<robot name="r">
  <link name="a"><collision><geometry><mesh filename="four.stl"/></geometry></collision></link>
  <link name="b"><collision><geometry><mesh filename="none.stl"/></geometry></collision></link>
  <joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>
</robot>
)";
  mesh::TriangleMesh four;
  four.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  four.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  VerbBench bench({{"r.urdf", kUrdf}, {"four.stl", mesh::write_stl(four)}});
  const std::string refused = simplified(bench.open("r.urdf"), {}).refused;
  EXPECT_NE(refused.find("collision a/1: left: it is coarse already, with 4 triangles"),
            std::string::npos)
      << refused;
  EXPECT_NE(refused.find("collision b/1: left: none.stl is not found"), std::string::npos)
      << refused;
}

/// A ball inside of a box's surface touches it only once the box is solid.
TEST(Simplify, NewContactsAreAvoided) {
  const auto robot = [](double radius, double x) {
    return fmt::format(R"(<robot name="r">
  <link name="base">
    <collision><origin xyz="0 0 9"/><geometry><sphere radius="0.1"/></geometry></collision>
  </link>
  <link name="a"><collision><geometry><mesh filename="box.stl"/></geometry></collision></link>
  <link name="b"><collision><geometry><sphere radius="{}"/></geometry></collision></link>
  <joint name="ja" type="fixed"><parent link="base"/><child link="a"/></joint>
  <joint name="jb" type="fixed"><origin xyz="{} 0 0"/><parent link="base"/><child link="b"/></joint>
</robot>
)",
                       radius, x);
  };
  const std::string box = mesh::write_stl(mesh::mesh_of(mesh::Box{{2, 2, 2}}));
  VerbBench bench({{"in.urdf", robot(0.7, 0)}, {"beside.urdf", robot(0.7, 3)}, {"box.stl", box}});
  const std::string refused = simplified(bench.open("in.urdf"), {}).refused;
  EXPECT_NE(refused.find("collision a/1: left: "), std::string::npos) << refused;
  EXPECT_EQ(simplified(bench.open("beside.urdf"), {}).refused, "");
}

}  // namespace
}  // namespace rigor::author
