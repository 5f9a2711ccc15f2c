// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <string>

#include <rigor/convert/urdf/robot.h>

#include "convert/loaded_robot.h"

namespace rigor::convert {
namespace {

UrdfOrigin origin_at(double x, double y, double z, double yaw = 0) {
  return {numbers({x, y, z}), numbers({0, 0, yaw})};
}

/// Every kind of part, the links not in the order of the tree.
UrdfRobot full_robot() {
  UrdfRobot robot{.name = "a & b"};
  robot.head = {"made of arm.sdf", "--nothing lost--"};
  robot.materials = {{.name = "red"}, {.name = "wood"}};
  robot.materials[0].rgba = {Number{1}, Number{0}, Number{0}, Number{0.5, "0.50"}};
  robot.materials[1].texture = "package://m/wood.png";
  UrdfLink arm{.name = "arm"};
  arm.comments = {Remark{" the upper\n  one "}};
  arm.visuals = {
      {"v", origin_at(0.1, 0, 0), UrdfMesh{"package://m/a.dae", numbers({1, -1, 2})}, "red"},
      {"", origin_at(0, 0, 0), UrdfSphere{{0.25}}, ""}};
  arm.collisions = {{"c", origin_at(0, 0, 1e-3, -1.5), UrdfCylinder{{0.1, "0.10"}, {2}}},
                    {"d", origin_at(0, 0, 0), UrdfBox{numbers({1, 2, 3})}}};
  UrdfLink base{.name = "base"};
  base.inertial = UrdfInertial{
      origin_at(0, 0.2, 0), {12.5, "12.50"}, {Number{1}, {-0.1}, {0}, {2}, {1e-5}, {2.5}}};
  UrdfJoint elbow{.name = "elbow", .type = "revolute", .parent = "base", .child = "arm"};
  elbow.origin = origin_at(1.0 / 3, 0, 0.5);
  elbow.axis = numbers({0, 0, -1});
  elbow.limit = UrdfLimit{Number{-1}, Number{1.25}, {30}, {2}};
  elbow.damping = Number{0.1};
  elbow.mimic = UrdfMimic{"slide", {2}, {-0.5}};
  elbow.safety = {Number{-0.9}, Number{1.2}, Number{10}, Number{11}};
  UrdfJoint slide{.name = "slide", .type = "prismatic", .parent = "base", .child = "tip"};
  slide.limit = UrdfLimit{std::nullopt, Number{0.4}, {1e16, "1e16"}, {1}};
  slide.friction = Number{0.7};
  robot.links = {arm, {.name = "tip"}, base};
  robot.joints = {elbow, slide};
  robot.blocks = {{"arm", "<mu1>0.5</mu1>\n<sensor name=\"s\">\n  <pose>0 0 0</pose>\n</sensor>\n"},
                  {"", "<static>true</static>\n"}};
  robot.rest = {"<transmission name=\"t\">\n  <type>x</type>\n</transmission>\n"};
  return robot;
}

TEST(UrdfText, StandsAsAHandWouldWriteIt) {
  const std::string expected = R"(<?xml version="1.0"?>
<!-- made of arm.sdf
     - -nothing lost- - -->
<robot name="a &amp; b">
  <material name="red">
    <color rgba="1 0 0 0.50"/>
  </material>

  <material name="wood">
    <texture filename="package://m/wood.png"/>
  </material>

  <link name="base">
    <inertial>
      <origin xyz="0 0.2 0"/>
      <mass value="12.50"/>
      <inertia ixx="1" ixy="-0.1" ixz="0" iyy="2" iyz="1e-05" izz="2.5"/>
    </inertial>
  </link>

  <!-- the upper
       one -->
  <link name="arm">
    <visual name="v">
      <origin xyz="0.1 0 0"/>
      <geometry>
        <mesh filename="package://m/a.dae" scale="1 -1 2"/>
      </geometry>
      <material name="red"/>
    </visual>
    <visual>
      <geometry>
        <sphere radius="0.25"/>
      </geometry>
    </visual>
    <collision name="c">
      <origin xyz="0 0 0.001" rpy="0 0 -1.5"/>
      <geometry>
        <cylinder radius="0.10" length="2"/>
      </geometry>
    </collision>
    <collision name="d">
      <geometry>
        <box size="1 2 3"/>
      </geometry>
    </collision>
  </link>

  <joint name="elbow" type="revolute">
    <parent link="base"/>
    <child link="arm"/>
    <origin xyz="0.3333333333333333 0 0.5"/>
    <axis xyz="0 0 -1"/>
    <limit lower="-1" upper="1.25" effort="30" velocity="2"/>
    <dynamics damping="0.1"/>
    <mimic joint="slide" multiplier="2" offset="-0.5"/>
    <safety_controller soft_lower_limit="-0.9" soft_upper_limit="1.2" k_position="10" k_velocity="11"/>
  </joint>

  <link name="tip"/>

  <joint name="slide" type="prismatic">
    <parent link="base"/>
    <child link="tip"/>
    <limit upper="0.4" effort="1e16" velocity="1"/>
    <dynamics friction="0.7"/>
  </joint>

  <gazebo reference="arm">
    <mu1>0.5</mu1>
    <sensor name="s">
      <pose>0 0 0</pose>
    </sensor>
  </gazebo>

  <gazebo>
    <static>true</static>
  </gazebo>

  <transmission name="t">
    <type>x</type>
  </transmission>
</robot>
)";
  EXPECT_EQ(urdf_text(full_robot()), expected);
}

TEST(UrdfText, ReadsBackAsTheSameNumbers) {
  const test::LoadedRobot robot(urdf_text(full_robot()));
  const model::Root& root = robot.root();
  ASSERT_TRUE(robot.loaded().facts.empty());
  ASSERT_EQ(root.links.size(), 3U);
  ASSERT_EQ(root.joints.size(), 2U);
  EXPECT_EQ(root.models[0].name.value, "a & b");
  const model::Inertial& inertial = root.links[0].inertial;
  EXPECT_EQ(inertial.mass.value, 12.5);
  EXPECT_EQ(inertial.pose.pose.value.translation, (model::Vector3{0, 0.2, 0}));
  EXPECT_EQ(inertial.ixy.value, -0.1);
  EXPECT_EQ(inertial.iyz.value, 1e-5);
  const model::Joint& elbow = root.joints[0];
  EXPECT_EQ(elbow.pose.pose.value.translation.x, 1.0 / 3);
  EXPECT_EQ(elbow.axes[0].upper.value, 1.25);
  EXPECT_EQ(elbow.axes[0].mimic->offset.value, -0.5);
  EXPECT_EQ(elbow.safety->soft_upper.value, 1.2);
  EXPECT_EQ(root.joints[1].axes[0].effort.value, 1e16);
  EXPECT_FALSE(root.joints[1].axes[0].lower.written);
  EXPECT_EQ(std::get<model::Mesh>(root.visuals[0].geometry.shape).scale.value,
            (model::Vector3{1, -1, 2}));
  EXPECT_EQ(root.gazebo_blocks.size(), 2U);
}

TEST(UrdfText, LeavesTextOfSeveralLinesAsItIs) {
  UrdfRobot robot{.name = "r"};
  robot.blocks = {{"", "<a>\n  1 2\n  3\n</a>\n<b>4\n5</b>\n<c/>\n"}};
  EXPECT_EQ(urdf_text(robot), R"(<?xml version="1.0"?>
<robot name="r">
  <gazebo>
    <a>
  1 2
  3
</a>
    <b>4
5</b>
    <c/>
  </gazebo>
</robot>
)");
}

TEST(UrdfText, SaysItsVersion) {
  UrdfRobot robot{.name = "r", .version = "1.1"};
  robot.links = {{.name = "a"}};
  robot.links[0].collisions = {{"", {}, UrdfCapsule{{1}, {2}}}};
  EXPECT_EQ(urdf_text(robot), R"(<?xml version="1.0"?>
<robot name="r" version="1.1">
  <link name="a">
    <collision>
      <geometry>
        <capsule radius="1" length="2"/>
      </geometry>
    </collision>
  </link>
</robot>
)");
}

TEST(UrdfText, WritesWhatIsNoTreeOnce) {
  UrdfRobot robot{.name = "r"};
  robot.links = {{.name = "a"}, {.name = "b"}, {.name = "c"}};
  robot.joints = {{.name = "ab", .type = "fixed", .parent = "a", .child = "b"},
                  {.name = "ba", .type = "fixed", .parent = "b", .child = "a"},
                  {.name = "cb", .type = "fixed", .parent = "c", .child = "b"},
                  {.name = "cx", .type = "fixed", .parent = "c", .child = "x"}};
  const std::string text = urdf_text(robot);
  for (const char* part :
       {"<link name=\"a\"/>", "<link name=\"b\"/>", "<link name=\"c\"/>", "<joint name=\"ab\"",
        "<joint name=\"ba\"", "<joint name=\"cb\"", "<joint name=\"cx\""}) {
    const std::size_t first = text.find(part);
    ASSERT_NE(first, std::string::npos) << part;
    EXPECT_EQ(text.find(part, first + 1), std::string::npos) << part;
  }
}

}  // namespace
}  // namespace rigor::convert
