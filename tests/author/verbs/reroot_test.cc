// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// reroot: poses by hand, and the robot that comes back.

#include <rigor/author/verbs/reroot.h>

#include <gtest/gtest.h>

#include <rigor/author/verbs/draft.h>
#include <rigor/author/verbs/robot_laws.h>

#include "author/verbs/verb_bench.h"

namespace rigor::author {
namespace {

/// Two joints: the second one meter above the first.
constexpr const char* kMast = R"(<robot name="mast">
  <link name="ground"><visual><geometry><box size="1 1 0.1"/></geometry></visual></link>
  <joint name="turn" type="continuous">
    <origin xyz="0 0 0.5"/> <!-- height of the ground plate -->
    <parent link="ground"/>
    <child link="mast"/>
    <axis xyz="0 0 1"/>
  </joint>
  <link name="mast">
    <inertial>
      <origin xyz="0 0 0.5"/>
      <mass value="2"/>
      <inertia ixx="0.2" iyy="0.2" izz="0.1" ixy="0" ixz="0" iyz="0"/>
    </inertial>
    <visual><origin xyz="0 0 0.5"/><geometry><box size="0.1 0.1 1"/></geometry></visual>
  </link>
  <joint name="nod" type="revolute">
    <origin xyz="0 0 1" rpy="0 0 1.5707963267948966"/>
    <parent link="mast"/>
    <child link="head"/>
    <axis xyz="1 0 0"/>
    <limit lower="-0.5" upper="1" effort="1" velocity="1"/>
  </joint>
  <link name="head"/>
</robot>
)";

/// libsdformat calls such a joint wheel_joint.
TEST(Reroot, AJointWithTheNameOfItsLink) {
  VerbBench bench({{"m.sdf", R"(<sdf version="1.4"><model name="m">
  <link name="base"/>
  <link name="wheel"><pose>1 0 0 0 0 0</pose></link>
  <joint name="wheel" type="revolute"><parent>base</parent><child>wheel</child>
    <axis><xyz>0 1 0</xyz></axis></joint>
</model></sdf>
)"}});
  const EditedModel& m = bench.open("m.sdf");
  EXPECT_TRUE(m.joint("wheel_joint"));
  const Change change = rerooted(m, "wheel");
  EXPECT_EQ(change.refused, "");
  EXPECT_TRUE(bench.prove(m, change).holds());
}

TEST(Reroot, TheFramesOnTheWay) {
  VerbBench bench({{"mast.urdf", kMast}});
  const EditedModel& mast = bench.open("mast.urdf");
  const Change change = rerooted(mast, "head");
  EXPECT_EQ(change.notes,
            (std::vector<std::string>{"joint nod is turned", "joint turn is turned"}));
  const std::string text = bench.text(mast, change);
  // The mast's frame is where the nod joint is now: its middle half a meter below.
  EXPECT_NE(text.find(R"(<visual><origin xyz="0 0 -0.5" rpy="0 0 -1.5707963267949"/>)"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find(R"(<origin xyz="0 0 -1" rpy="0 0 -1.5707963267949"/> <!-- height)"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find(R"(<parent link="head"/>
    <child link="mast"/>
    <axis xyz="-1 0 0"/>
    <limit lower="-0.5" upper="1")"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find(R"(<visual><origin xyz="0 0 -0.5" rpy="0 0 0"/><geometry><box size="1 1)"),
            std::string::npos)
      << text;
  const EditedModel& turned = bench.open_text("mast.urdf", text);
  const Change back = rerooted(turned, "ground");
  const std::string again = bench.text(turned, back);
  // The ground's frame was left at the joint's: half a meter up.
  robot::Robot expected = mast.robot;
  describe_in(expected, mast.body_index("ground"), {{0, 0, 0.5}, {}});
  expected.bodies[mast.body_index("ground")].X_MB = {};
  robot::connect(expected);
  EXPECT_EQ(VerbBench::words(
                differences_at_rounding(expected, bench.open_text("mast.urdf", again).robot)),
            "");
}

TEST(Reroot, InSdfLinksStayWhereTheyAre) {
  constexpr const char* kSdf = R"(<sdf version="1.9"><model name="m">
  <link name="base"><pose>0 0 1 0 0 0</pose></link>
  <link name="arm"><pose>0.5 0 1 0 0 0</pose></link>
  <joint name="j" type="revolute">
    <parent>base</parent><child>arm</child>
    <axis><xyz>0 1 0</xyz></axis>
  </joint>
</model></sdf>
)";
  VerbBench bench({{"m.sdf", kSdf}});
  const EditedModel& model = bench.open("m.sdf");
  EXPECT_EQ(bench.text(model, rerooted(model, "arm")), R"(<sdf version="1.9"><model name="m">
  <link name="base"><pose>0 0 1 0 0 0</pose></link>
  <link name="arm"><pose>0.5 0 1 0 0 0</pose></link>
  <joint name="j" type="revolute">
    <pose relative_to="arm">0 0 0 0 0 0</pose>
    <parent>arm</parent><child>base</child>
    <axis><xyz>0 -1 0</xyz></axis>
  </joint>
</model></sdf>
)");
}

TEST(Reroot, WhatItRefuses) {
  VerbBench bench({{"mast.urdf", kMast}, {"w.sdf", R"(<sdf version="1.9"><model name="m">
  <link name="a"/> <joint name="j" type="fixed"><parent>world</parent><child>a</child></joint>
</model></sdf>)"}});
  EXPECT_EQ(rerooted(bench.open("mast.urdf"), "ground").refused, "link 'ground' is the root");
  EXPECT_EQ(rerooted(bench.open("mast.urdf"), "foot").refused, "no link is named 'foot'");
  EXPECT_EQ(rerooted(bench.open("w.sdf"), "a").refused, "the robot is fixed to the world");
}

TEST(ToRpy, IsExactWhereThePitchIsARightAngle) {
  for (const double pitch : {0.3, -1.2, 1.5707963267948966, 1.5707963267, -1.57079632679}) {
    const model::Quaternion q = model::from_rpy(0.7, pitch, -2.1);
    const model::Vector3 rpy = to_rpy(q);
    const model::Quaternion r = model::from_rpy(rpy.x, rpy.y, rpy.z);
    EXPECT_NEAR(std::abs(q.w * r.w + q.x * r.x + q.y * r.y + q.z * r.z), 1, 1e-15);
    const model::Quaternion apart = conjugate(q) * r;
    EXPECT_NEAR(apart.x, 0, 1e-15);
    EXPECT_NEAR(apart.y, 0, 1e-15);
    EXPECT_NEAR(apart.z, 0, 1e-15);
  }
}

}  // namespace
}  // namespace rigor::author
