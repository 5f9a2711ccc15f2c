// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// lump: sums by hand, and where things end up.

#include <rigor/author/verbs/lump/lump.h>

#include <gtest/gtest.h>

#include "author/verbs/verb_bench.h"

namespace rigor::author {
namespace {

TEST(Lump, AUrdfsFixedJoints) {
  constexpr const char* kTower = R"(<robot name="tower">
  <link name="base"/>
  <joint name="plate_joint" type="fixed">
    <origin xyz="0 0 1"/><parent link="base"/><child link="plate"/>
  </joint>
  <link name="plate">
    <inertial>
      <origin xyz="0 0 0.5"/>
      <mass value="2"/>
      <inertia ixx="0.5" iyy="0.5" izz="0.25" ixy="0" ixz="0" iyz="0"/>
    </inertial>
    <visual>
      <!-- the plate -->
      <geometry><box size="1 1 1"/></geometry>
    </visual>
  </link>
  <joint name="turn" type="continuous">
    <origin xyz="0 0 0.5"/><parent link="plate"/><child link="top"/><axis xyz="0 0 1"/>
  </joint>
  <link name="top"/>
  <gazebo reference="plate"><mu1>0.5</mu1></gazebo>
</robot>
)";
  VerbBench bench({{"tower.urdf", kTower}});
  const EditedModel& tower = bench.open("tower.urdf");
  EXPECT_EQ(bench.text(tower, lumped(tower, {})), R"(<robot name="tower">
  <link name="base">
    <inertial>
      <origin xyz="0 0 1.5"/>
      <mass value="2"/>
      <inertia ixx="0.5" ixy="0" ixz="0" iyy="0.5" iyz="0" izz="0.25"/>
    </inertial>
    <visual>
      <origin xyz="0 0 1" rpy="0 0 0"/>
      <!-- the plate -->
      <geometry><box size="1 1 1"/></geometry>
    </visual>
  </link>
  <joint name="turn" type="continuous">
    <origin xyz="0 0 1.5"/><parent link="base"/><child link="top"/><axis xyz="0 0 1"/>
  </joint>
  <link name="top"/>
  <gazebo reference="base"><mu1>0.5</mu1></gazebo>
</robot>
)");
}

TEST(Lump, InSdfAFrameStaysWhereTheLinkWas) {
  constexpr const char* kSdf = R"(<sdf version="1.9"><model name="m">
  <link name="a">
    <inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>
    <visual name="v"><geometry><box><size>1 1 1</size></box></geometry></visual>
  </link>
  <link name="b">
    <pose>2 0 0 0 0 0</pose>
    <inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>
    <visual name="v"><geometry><sphere><radius>1</radius></sphere></geometry></visual>
  </link>
  <link name="c"><pose relative_to="b">0 0 1 0 0 0</pose></link>
  <joint name="j" type="fixed"><parent>a</parent><child>b</child></joint>
  <joint name="k" type="ball"><parent>b</parent><child>c</child></joint>
</model></sdf>
)";
  VerbBench bench({{"m.sdf", kSdf}});
  const EditedModel& model = bench.open("m.sdf");
  const std::string text = bench.text(model, lumped(model, {}));
  const robot::Robot& robot = bench.open_text("m.sdf", text).robot;
  ASSERT_EQ(robot.bodies.size(), 2U);
  // Two masses of 1 kg, 2 m apart.
  EXPECT_EQ(robot.bodies[0].mass.mass, 2);
  EXPECT_EQ(robot.bodies[0].mass.com, (model::Vector3{1, 0, 0}));
  EXPECT_EQ(robot.bodies[0].mass.about_com, (mass::Inertia{2, 0, 0, 4, 0, 4}));
  ASSERT_EQ(robot.bodies[0].visuals.size(), 2U);
  EXPECT_EQ(robot.bodies[0].visuals[1].name, "b_v");
  EXPECT_EQ(robot.bodies[0].visuals[1].X_BS.translation, (model::Vector3{2, 0, 0}));
  EXPECT_NE(text.find("<frame name=\"b\" attached_to=\"a\">"), std::string::npos) << text;
  EXPECT_NE(text.find("<parent>b</parent><child>c</child>"), std::string::npos) << text;
}

/// Sums in double precision: 0.1 + 0.2 is 0.30000000000000004.
TEST(Lump, NumbersAreWrittenAsAPersonWould) {
  VerbBench bench({{"r.urdf", R"(<robot name="r">
  <link name="a">
    <inertial>
      <origin xyz="0 0 0.06"/>
      <mass value="0.1"/>
      <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/>
    </inertial>
  </link>
  <joint name="j" type="fixed"><origin xyz="0 0 0.03"/><parent link="a"/><child link="b"/></joint>
  <link name="b">
    <inertial>
      <origin xyz="0 0 0.03"/>
      <mass value="0.2"/>
      <inertia ixx="0.2" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.2"/>
    </inertial>
  </link>
</robot>
)"}});
  const EditedModel& robot = bench.open("r.urdf");
  const std::string text = bench.text(robot, lumped(robot, {}));
  EXPECT_NE(text.find("<origin xyz=\"0 0 0.06\"/>\n      <mass value=\"0.3\"/>\n      <inertia "
                      "ixx=\"0.3\" ixy=\"0\" ixz=\"0\" iyy=\"0.3\" iyz=\"0\" izz=\"0.3\"/>"),
            std::string::npos)
      << text;
}

TEST(Lump, WhatItRefuses) {
  VerbBench bench(
      {{"m.sdf", R"(<sdf version="1.6"><model name="m"><link name="a"/></model></sdf>)"},
       {"r.urdf", R"(<robot name="r"><link name="a"/></robot>)"}});
  EXPECT_EQ(lumped(bench.open("m.sdf"), {}).refused, "no link is on a fixed joint to another");
  EXPECT_EQ(lumped(bench.open("r.urdf"), {}).refused, "no link is on a fixed joint to another");
  EXPECT_EQ(lumped(bench.open("r.urdf"), {"a"}).refused, "link 'a' is on no fixed joint");
}

/// Before 1.7 there are no frames: joints name the holder, and poses are numbers in it.
TEST(Lump, AnOldSdfsFixedJoints) {
  constexpr const char* kOld = R"(<sdf version="1.5">
  <model name="m">
    <link name="base">
      <inertial>
        <mass>1</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
    </link>
    <link name="mast">
      <pose>0 0 2 0 0 0</pose>
      <inertial>
        <mass>1</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
      <collision name="c">
        <geometry><sphere><radius>1</radius></sphere></geometry>
      </collision>
    </link>
    <link name="arm">
      <pose>0 0 3 0 0 0</pose>
    </link>
    <joint name="fix" type="fixed">
      <parent>base</parent>
      <child>mast</child>
    </joint>
    <joint name="turn" type="revolute">
      <parent>mast</parent>
      <child>arm</child>
      <axis><xyz>0 0 1</xyz></axis>
    </joint>
    <plugin name="p" filename="p.so"><bodyName>mast</bodyName></plugin>
  </model>
</sdf>
)";
  VerbBench bench({{"m.sdf", kOld}});
  const EditedModel& m = bench.open("m.sdf");
  const Change change = lumped(m, {});
  const std::string text = bench.text(m, change);
  EXPECT_NE(text.find("<pose>0 0 2 0 0 0</pose>\n        <geometry><sphere>"), std::string::npos)
      << text;
  EXPECT_NE(text.find("<parent>base</parent>\n      <child>arm</child>"), std::string::npos)
      << text;
  EXPECT_NE(text.find("<mass>2</mass>"), std::string::npos) << text;
  // Steiner: 2 · (1 + 1 · 1²) about the middle, at z = 1.
  EXPECT_NE(text.find("<ixx>4</ixx>"), std::string::npos) << text;
  EXPECT_EQ(text.find("<frame"), std::string::npos) << text;
  EXPECT_NE(text.find("<bodyName>mast</bodyName>"), std::string::npos) << text;
  ASSERT_EQ(change.notes.size(), 2U);
  EXPECT_EQ(change.notes[1], "m.sdf:31: a plugin names link mast, which is part of base now");
}

}  // namespace
}  // namespace rigor::author
