// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// scale: each number by its law.

#include <rigor/author/verbs/scale.h>

#include <gtest/gtest.h>

#include "author/verbs/verb_bench.h"

namespace rigor::author {
namespace {

TEST(Scale, EachNumberOfAUrdfByItsLaw) {
  constexpr const char* kCrane = R"(<robot name="crane">
  <link name="base">
    <inertial>
      <origin xyz="0 0 0.1"/>
      <mass value="3"/>
      <inertia ixx="2" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>
    </inertial>
    <visual><geometry><mesh filename="a.stl"/></geometry></visual>
    <collision><geometry><cylinder radius="0.25" length="0.5"/></geometry></collision>
  </link>
  <joint name="turn" type="revolute">
    <origin xyz="0.1 0 0.2" rpy="0 0 1"/>
    <parent link="base"/> <child link="arm"/>
    <axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="10" velocity="2"/>
    <dynamics damping="0.5" friction="0.25"/>
  </joint>
  <link name="arm"/>
  <joint name="lift" type="prismatic">
    <parent link="arm"/> <child link="hook"/>
    <axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="10" velocity="2"/>
    <dynamics damping="0.5" friction="0.25"/>
  </joint>
  <link name="hook"/>
</robot>
)";
  constexpr const char* kFourTimes = R"(<robot name="crane">
  <link name="base">
    <inertial>
      <origin xyz="0 0 0.4"/>
      <mass value="192"/>
      <inertia ixx="2048" ixy="0" ixz="0" iyy="1024" iyz="0" izz="1024"/>
    </inertial>
    <visual><geometry><mesh filename="a.stl" scale="4 4 4"/></geometry></visual>
    <collision><geometry><cylinder radius="1" length="2"/></geometry></collision>
  </link>
  <joint name="turn" type="revolute">
    <origin xyz="0.4 0 0.8" rpy="0 0 1"/>
    <parent link="base"/> <child link="arm"/>
    <axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="2560" velocity="1"/>
    <dynamics damping="256" friction="64"/>
  </joint>
  <link name="arm"/>
  <joint name="lift" type="prismatic">
    <parent link="arm"/> <child link="hook"/>
    <axis xyz="0 0 1"/>
    <limit lower="-4" upper="4" effort="640" velocity="4"/>
    <dynamics damping="16" friction="16"/>
  </joint>
  <link name="hook"/>
</robot>
)";
  VerbBench bench({{"crane.urdf", kCrane}});
  const EditedModel& crane = bench.open("crane.urdf");
  EXPECT_EQ(bench.text(crane, scaled(crane, 4)), kFourTimes);
  const EditedModel& large = bench.open_text("crane.urdf", kFourTimes);
  const std::string back = bench.text(large, scaled(large, 0.25));
  EXPECT_EQ(VerbBench::words(
                differences_at_rounding(crane.robot, bench.open_text("crane.urdf", back).robot)),
            "");
}

TEST(Scale, WhatSdfTakesWhereNothingIsWritten) {
  constexpr const char* kSdf = R"(<sdf version="1.9"><model name="m">
  <pose>0 0 1 0 0 0</pose>
  <link name="a">
    <pose>0 0 1 0 0 0</pose>
    <collision name="c">
      <geometry><box><size>1 2 3</size></box></geometry>
      <surface><contact><ode><kp>100</kp></ode></contact></surface>
    </collision>
  </link>
  <plugin name="p" filename="f"><wheel_radius>0.1</wheel_radius></plugin>
</model></sdf>
)";
  VerbBench bench({{"m.sdf", kSdf}});
  const EditedModel& model = bench.open("m.sdf");
  const Change change = scaled(model, 2);
  EXPECT_EQ(bench.text(model, change), R"(<sdf version="1.9"><model name="m">
  <pose>0 0 1 0 0 0</pose>
  <link name="a">
    <pose>0 0 2 0 0 0</pose>
    <collision name="c">
      <geometry><box><size>2 4 6</size></box></geometry>
      <surface><contact><ode><kp>400</kp></ode></contact></surface>
    </collision>
    <inertial>
      <mass>8</mass>
      <inertia>
        <ixx>32</ixx>
        <iyy>32</iyy>
        <izz>32</izz>
      </inertia>
    </inertial>
  </link>
  <plugin name="p" filename="f"><wheel_radius>0.1</wheel_radius></plugin>
</model></sdf>
)");
  EXPECT_EQ(change.notes,
            (std::vector<std::string>{"m.sdf:10: may be a length, kept: <wheel_radius>0.1"}));
}

/// Of the YAML that was found the one that names a joint of the robot, of a named one what it holds.
TEST(Scale, LengthsInTheYamlOfControllersAreListed) {
  constexpr const char* kRover = R"(<robot name="rover">
  <link name="base"/>
  <joint name="left_wheel_joint" type="continuous">
    <parent link="base"/> <child link="wheel"/>
  </joint>
  <link name="wheel"/>
</robot>
)";
  constexpr const char* kDrive =
      "diff_drive:\n"
      "  ros__parameters:\n"
      "    left_wheel_names: [left_wheel_joint]\n"
      "    wheel_radius: 0.1  # m\n"
      "    wheel_radius_multiplier: 1.0\n"
      "    publish_rate: 50\n"
      "    tracks: {front_track: 0.5, name: track}\n";
  VerbBench bench({{"rover.urdf", kRover},
                   {"drive.yaml", kDrive},
                   {"other.yaml", "wheel_names: [other_joint]\nwheel_radius: 0.3\n"},
                   {"named.yaml", "wheel_separation: 0.4\n"}});
  const EditedModel& rover = bench.open("rover.urdf");
  const ReferringFiles files({"rover.urdf", "named.yaml"}, {"drive.yaml", "other.yaml"});
  EXPECT_EQ(scaled(rover, 2, files).notes,
            (std::vector<std::string>{"named.yaml:1: may be a length, kept: wheel_separation: 0.4",
                                      "drive.yaml:4: may be a length, kept: wheel_radius: 0.1",
                                      "drive.yaml:7: may be a length, kept: front_track: 0.5"}));
}

TEST(Scale, FactorsThatAreNone) {
  VerbBench bench(
      {{"m.sdf", R"(<sdf version="1.9"><model name="m"><link name="a"/></model></sdf>)"}});
  EXPECT_NE(scaled(bench.open("m.sdf"), 0).refused, "");
  EXPECT_NE(scaled(bench.open("m.sdf"), -1).refused, "");
  for (const double factor : {1e300, 1e-300, 1e62})
    EXPECT_NE(scaled(bench.open("m.sdf"), factor, {}).refused, "") << factor;
}

TEST(Scale, ANumberThatWouldOverflow) {
  VerbBench bench({{"m.urdf", R"(<robot name="m"><link name="a"><inertial><mass value="1e200"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link></robot>)"}});
  EXPECT_EQ(scaled(bench.open("m.urdf"), 1e40).refused,
            "1e+200 scaled by 1e+40 is out of the range of numbers");
  EXPECT_EQ(scaled(bench.open("m.urdf"), 10).refused, "");
}

}  // namespace
}  // namespace rigor::author
