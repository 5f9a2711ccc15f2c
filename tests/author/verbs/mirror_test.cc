// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// mirror: images by hand, and that the image moves as the original does.

#include <rigor/author/verbs/mirror.h>

#include <gtest/gtest.h>

#include <rigor/author/verbs/robot_laws.h>

#include "author/verbs/verb_bench.h"

namespace rigor::author {
namespace {

constexpr const char* kWalker = R"(<robot name="walker">
  <link name="torso"/>
  <joint name="left_hip" type="revolute">
    <origin xyz="0.1 0.2 0" rpy="0.1 0 0.3"/>
    <parent link="torso"/> <child link="left_leg"/>
    <axis xyz="0 0.6 0.8"/>
    <limit lower="-0.5" upper="1" effort="1" velocity="1"/>
  </joint>
  <!-- shin and all -->
  <link name="left_leg">
    <inertial>
      <origin xyz="0.01 0.02 -0.2"/>
      <mass value="2"/>
      <inertia ixx="0.03" ixy="0.001" ixz="0.002" iyy="0.04" iyz="0.003" izz="0.05"/>
    </inertial>
    <collision><origin xyz="0 0.05 -0.2" rpy="0 0 0.5"/><geometry><box size="0.1 0.2 0.4"/></geometry></collision>
    <visual><geometry><mesh filename="leg.stl"/></geometry></visual>
  </link>
  <joint name="left_slide" type="prismatic">
    <parent link="left_leg"/> <child link="left_foot"/>
    <axis xyz="0 1 0"/>
    <limit lower="0" upper="1" effort="1" velocity="1"/>
  </joint>
  <link name="left_foot"/>
</robot>
)";

TEST(Mirror, ALegInItsPlace) {
  VerbBench bench({{"walker.urdf", kWalker}});
  const EditedModel& walker = bench.open("walker.urdf");
  const std::string text = bench.text(walker, mirrored(walker, "left_leg", {}));
  const auto has = [&](const char* part) {
    EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
  };
  has(R"(<origin xyz="0.1 -0.2 0" rpy="-0.1 0 -0.3"/>)");
  // A rotation about a is one about -S a.
  has(R"(<axis xyz="0 0.6 -0.8"/>
    <limit lower="-0.5" upper="1")");
  has(R"(<origin xyz="0.01 -0.02 -0.2"/>)");
  has(R"(ixx="0.03" ixy="-0.001" ixz="0.002" iyy="0.04" iyz="-0.003" izz="0.05")");
  has(R"(<origin xyz="0 -0.05 -0.2" rpy="0 0 -0.5"/>)");
  has(R"(<mesh filename="leg.stl" scale="1 -1 1"/>)");
  has(R"(<axis xyz="0 -1 0"/>)");  // what slides goes along S a
  const EditedModel& image = bench.open_text("walker.urdf", text);
  const std::string again = bench.text(image, mirrored(image, "left_leg", {}));
  EXPECT_EQ(VerbBench::words(
                differences_at_rounding(walker.robot, bench.open_text("walker.urdf", again).robot)),
            "");
}

/// Not by the law: at the same positions each body of the copy is where the reflected points of the original are.
TEST(Mirror, TheCopyMovesAsItsOriginalDoes) {
  VerbBench bench({{"walker.urdf", kWalker}});
  const EditedModel& walker = bench.open("walker.urdf");
  const std::string text =
      bench.text(walker, mirrored(walker, "left_leg", {MirrorPlane::kXz, "left", "right"}));
  EXPECT_EQ(text.find(kWalker, 0), std::string::npos);
  EXPECT_TRUE(
      text.starts_with(std::string(kWalker).substr(0, std::string(kWalker).find("</robot>"))));
  const robot::Robot& both = bench.open_text("walker.urdf", text).robot;
  ASSERT_EQ(both.joints.size(), 4U);
  EXPECT_EQ(both.joints[2].name, "right_hip");
  const robot::Positions positions{{0.4}, {0.3}, {0.4}, {0.3}};
  const std::vector<model::Pose> X = body_poses(both, positions);
  ASSERT_EQ(X.size(), 5U);
  const model::Vector3 points[] = {{0, 0, 0}, {0.3, 0.1, -0.2}, {0, 0.5, 0.5}};
  for (const std::size_t body : {1U, 2U}) {
    for (const model::Vector3& p : points) {
      const model::Vector3 original = transform(X[body], p);
      const model::Vector3 image = transform(X[body + 2], {p.x, -p.y, p.z});
      EXPECT_NEAR(image.x, original.x, 1e-15);
      EXPECT_NEAR(image.y, -original.y, 1e-15);
      EXPECT_NEAR(image.z, original.z, 1e-15);
    }
  }
}

TEST(Mirror, SdfAboutThePlaneOfTheCarrier) {
  constexpr const char* kSdf = R"(<sdf version="1.9"><model name="m">
  <link name="base"><pose>0 1 0 0 0 0</pose></link>
  <link name="arm"><pose>0.5 1.25 0 0 0 0.5</pose></link>
  <link name="hand"><pose relative_to="arm">0.1 0.2 0.3 0 0 0.5</pose></link>
  <joint name="j" type="revolute">
    <parent>base</parent><child>arm</child>
    <axis><xyz expressed_in="__model__">0 0 1</xyz></axis>
  </joint>
  <joint name="k" type="fixed"><parent>arm</parent><child>hand</child></joint>
</model></sdf>
)";
  VerbBench bench({{"m.sdf", kSdf}});
  const EditedModel& model = bench.open("m.sdf");
  EXPECT_EQ(bench.text(model, mirrored(model, "arm", {})), R"(<sdf version="1.9"><model name="m">
  <link name="base"><pose>0 1 0 0 0 0</pose></link>
  <link name="arm"><pose>0.5 0.75 0 0 0 -0.5</pose></link>
  <link name="hand"><pose relative_to="arm">0.1 -0.2 0.3 0 0 -0.5</pose></link>
  <joint name="j" type="revolute">
    <parent>base</parent><child>arm</child>
    <axis><xyz expressed_in="__model__">0 0 -1</xyz></axis>
  </joint>
  <joint name="k" type="fixed"><parent>arm</parent><child>hand</child></joint>
</model></sdf>
)");
}

TEST(Mirror, WhatItRefuses) {
  VerbBench bench({{"walker.urdf", kWalker}});
  const EditedModel& walker = bench.open("walker.urdf");
  EXPECT_EQ(mirrored(walker, "arm", {}).refused, "no link is named 'arm'");
  EXPECT_NE(mirrored(walker, "left_leg", {MirrorPlane::kXz, "links", "rechts"})
                .refused.find("has no 'links' in it"),
            std::string::npos);
}

}  // namespace
}  // namespace rigor::author
