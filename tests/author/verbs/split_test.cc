// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// split: where things end up, sums by hand, and lumped again.

#include <rigor/author/verbs/split.h>

#include <cmath>

#include <gtest/gtest.h>

#include <rigor/author/verbs/lump/lump.h>

#include "author/verbs/verb_bench.h"

namespace rigor::author {
namespace {

constexpr const char* kSplitMast = R"(<robot name="arm">
  <link name="arm">
    <inertial>
      <origin xyz="0 0 0.5"/>
      <mass value="3"/>
      <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="0.5"/>
    </inertial>
    <visual>
      <geometry><box size="0.1 0.1 1"/></geometry>
    </visual>
    <!-- the tip -->
    <visual name="tip">
      <origin xyz="0 0 1"/>
      <geometry><sphere radius="0.1"/></geometry>
    </visual>
  </link>
  <joint name="turn" type="continuous">
    <origin xyz="0 0 1.25"/>
    <parent link="arm"/>
    <child link="hand"/>
    <axis xyz="0 0 1"/>
  </joint>
  <link name="hand"/>
</robot>
)";

SplitRequest mast_request() {
  SplitRequest request;
  request.name = "tip_link";
  request.X_LN = {{0, 0, 1}, {}};
  request.take = {"tip", "turn"};
  return request;
}

TEST(Split, AUrdfsLinkWithItsMassLeft) {
  VerbBench bench({{"arm.urdf", kSplitMast}});
  const EditedModel& arm = bench.open("arm.urdf");
  EXPECT_EQ(bench.text(arm, split(arm, "arm", mast_request())), R"(<robot name="arm">
  <link name="arm">
    <inertial>
      <origin xyz="0 0 0.5"/>
      <mass value="3"/>
      <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="0.5"/>
    </inertial>
    <visual>
      <geometry><box size="0.1 0.1 1"/></geometry>
    </visual>
    <!-- the tip -->
  </link>
  <link name="tip_link">
    <visual name="tip">
      <origin xyz="0 0 0"/>
      <geometry><sphere radius="0.1"/></geometry>
    </visual>
  </link>
  <joint name="arm_to_tip_link" type="fixed">
    <origin xyz="0 0 1" rpy="0 0 0"/>
    <parent link="arm"/>
    <child link="tip_link"/>
  </joint>
  <joint name="turn" type="continuous">
    <origin xyz="0 0 0.25"/>
    <parent link="tip_link"/>
    <child link="hand"/>
    <axis xyz="0 0 1"/>
  </joint>
  <link name="hand"/>
</robot>
)");
}

/// One third of the mass in a ball at the tip: what remains has its center where moments balance.
TEST(Split, TheMassOfShapes) {
  VerbBench bench({{"arm.urdf", kSplitMast}});
  const EditedModel& arm = bench.open("arm.urdf");
  SplitRequest request = mast_request();
  request.share = SplitMass::kGiven;
  request.mass = 1;
  const Change change = split(arm, "arm", request);
  const ProvenChange proven = bench.prove(arm, change);
  ASSERT_TRUE(proven.holds()) << proven.refused << VerbBench::words(proven.unasked);
  const robot::Body& left = proven.after->robot.bodies[proven.after->body_index("arm")];
  const robot::Body& tip = proven.after->robot.bodies[proven.after->body_index("tip_link")];
  EXPECT_NEAR(tip.mass.mass, 1, 1e-12);
  EXPECT_NEAR(tip.mass.about_com.ixx, 0.4 * 0.01, 1e-12);  // 2/5 m r²
  EXPECT_NEAR(left.mass.mass, 2, 1e-12);
  EXPECT_NEAR(left.mass.com.z, (3 * 0.5 - 1 * 1.0) / 2, 1e-12);
  const ProvenChange lumped_again = bench.prove(*proven.after, lumped(*proven.after, {"tip_link"}));
  ASSERT_TRUE(lumped_again.holds());
  EXPECT_EQ(VerbBench::words(differences_at_rounding(arm.robot, lumped_again.after->robot)), "");
}

/// The moments of a rod are 0, a and a: rotated, they miss the triangle inequality by a rounding, and libsdformat
/// rejects the link. The new one has them as they were, in a frame that is rotated.
TEST(Split, TheTensorOfARodIsNotRotated) {
  constexpr const char* kRod = R"(<sdf version="1.6">
  <model name="m">
    <link name="rod">
      <inertial>
        <mass>3</mass>
        <inertia>
          <ixx>3</ixx>
          <iyy>0</iyy>
          <izz>3</izz>
        </inertia>
      </inertial>
      <collision name="a"><geometry><mesh><uri>rod.stl</uri></mesh></geometry></collision>
      <visual name="b"><geometry><mesh><uri>rod.stl</uri></mesh></geometry></visual>
    </link>
  </model>
</sdf>
)";
  VerbBench bench({{"rod.sdf", kRod}});
  const EditedModel& rod = bench.open("rod.sdf");
  SplitRequest request;
  request.name = "part";
  request.X_LN = {{0.1, -0.2, 0.3}, model::from_rpy(0.4, -0.5, 0.6)};
  request.take = {"b"};
  request.share = SplitMass::kGiven;
  request.mass = 1;
  const Change change = split(rod, "rod", request);
  const ProvenChange proven = bench.prove(rod, change);
  ASSERT_TRUE(proven.holds()) << proven.refused << VerbBench::words(proven.unasked);
  const model::Root& after = proven.after->root();
  const model::Inertial& part = after[proven.after->link("part")].inertial;
  EXPECT_EQ(part.ixx.value, 1);
  EXPECT_EQ(part.iyy.value, 0);
  EXPECT_EQ(part.izz.value, 1);
  EXPECT_EQ(part.ixy.value, 0);
  // In the rod's frame nothing is rotated.
  const model::Pose back = compose(request.X_LN, part.pose.pose.value);
  EXPECT_LT(length(back.translation), 1e-12);
  EXPECT_NEAR(std::abs(back.rotation.w), 1, 1e-12);
}

/// What is computed is written number by number, by split and by lump; what its author did not write is added.
TEST(Split, CommentsInTheInertialStay) {
  constexpr const char* kSdf = R"(<sdf version="1.6">
  <model name="m">
    <link name="base">
      <inertial>
        <!-- weighed -->
        <pose>0 0 0 0 0 1.5707963267948966</pose>
        <mass>4</mass>
        <inertia>
          <ixx>1</ixx>  <!-- from CAD -->
          <iyy>2</iyy>
          <izz>2</izz>
        </inertia>
      </inertial>
      <visual name="a"><geometry><box><size>1 1 1</size></box></geometry></visual>
      <visual name="b">
        <pose>1 1 0 0 0 0</pose>
        <geometry><sphere><radius>0.5</radius></sphere></geometry>
      </visual>
    </link>
  </model>
</sdf>
)";
  VerbBench bench({{"m.sdf", kSdf}});
  const EditedModel& before = bench.open("m.sdf");
  SplitRequest request;
  request.name = "ball";
  request.X_LN = {{1, 1, 0}, {}};
  request.take = {"b"};
  request.share = SplitMass::kGiven;
  request.mass = 0.1;
  const ProvenChange proven = bench.prove(before, split(before, "base", request));
  ASSERT_TRUE(proven.holds()) << proven.refused << VerbBench::words(proven.unasked);
  const std::string& text = proven.files.front().text;
  EXPECT_NE(text.find("        <!-- weighed -->\n        <pose>-0.0256410256410256"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("<mass>3.9</mass>"), std::string::npos) << text;
  EXPECT_NE(text.find("</ixx>  <!-- from CAD -->"), std::string::npos) << text;
  EXPECT_NE(text.find("<ixy>"), std::string::npos) << text;
  const ProvenChange again = bench.prove(*proven.after, lumped(*proven.after, {"ball"}));
  ASSERT_TRUE(again.holds()) << again.refused << VerbBench::words(again.unasked);
  EXPECT_NE(again.files.front().text.find("<!-- from CAD -->"), std::string::npos);
  EXPECT_EQ(VerbBench::words(differences_at_rounding(before.robot, again.after->robot)), "");
}

/// Its five numbers are no place that could be told from another frame.
TEST(Split, APoseThatIsNoneIsNamed) {
  constexpr const char* kSdf = R"(<sdf version="1.6">
  <model name="m">
    <link name="base">
      <visual name="a">
        <pose>0 -0.25 0 0 0</pose>
        <geometry><box><size>1 1 1</size></box></geometry>
      </visual>
    </link>
    <link name="tip"/>
    <joint name="j" type="fixed"><parent>tip</parent><child>base</child></joint>
  </model>
</sdf>
)";
  VerbBench bench({{"m.sdf", kSdf}});
  const EditedModel& model = bench.open("m.sdf");
  SplitRequest request;
  request.X_LN = {{0, 0, 1}, {}};
  request.take = {"a"};
  request.share = SplitMass::kShapes;
  EXPECT_EQ(split(model, "base", request).refused, "line 5: the pose is not written as one");
  EXPECT_EQ(lumped(model, {}).refused, "line 5: the pose is not written as one");
}

TEST(Split, AnSdfLinkAtAFrame) {
  constexpr const char* kSdf = R"(<sdf version="1.7">
  <model name="m">
    <link name="base">
      <inertial>
        <mass>4</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
      <collision name="box">
        <pose>0.5 0 0 0 0 0</pose>
        <geometry><box><size>1 1 1</size></box></geometry>
      </collision>
      <collision name="other">
        <geometry><box><size>1 1 1</size></box></geometry>
      </collision>
    </link>
    <frame name="cut" attached_to="base">
      <pose>0.5 0 0 0 0 0</pose>
    </frame>
  </model>
</sdf>
)";
  VerbBench bench({{"m.sdf", kSdf}});
  const EditedModel& before = bench.open("m.sdf");
  SplitRequest request;
  request.X_LN = *place_in_link(before, "base", "cut");
  EXPECT_EQ(request.X_LN.translation.x, 0.5);
  request.take = {"collision/1"};
  EXPECT_NE(split(before, "base", request).refused.find("--mass"), std::string::npos);
  request.share = SplitMass::kShapes;
  const std::string text = bench.text(before, split(before, "base", request));
  EXPECT_NE(text.find(R"(    <link name="base_part">
      <pose relative_to="base">0.5 0 0 0 0 0</pose>
      <inertial>)"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("<mass>2</mass>"), std::string::npos) << text;
}

/// One link before has one gravity and one friction: so have both after.
TEST(Split, WhatALinkSaysOfItselfBothSay) {
  VerbBench bench({{"m.sdf", R"(<sdf version="1.9"><model name="m">
  <link name="a">
    <gravity>false</gravity>
    <velocity_decay>
      <linear>0.5</linear>
    </velocity_decay>
    <inertial><mass>2</mass></inertial>
    <visual name="v"><geometry><sphere><radius>1</radius></sphere></geometry></visual>
    <visual name="w"><geometry><sphere><radius>1</radius></sphere></geometry></visual>
  </link>
</model></sdf>
)"},
                   {"r.urdf", R"(<robot name="r">
  <link name="a">
    <visual name="v"><geometry><sphere radius="1"/></geometry></visual>
    <visual name="w"><geometry><sphere radius="1"/></geometry></visual>
  </link>
  <gazebo reference="a"><material>Gazebo/Red</material><sensor name="s" type="imu"/></gazebo>
</robot>
)"}});
  SplitRequest request;
  request.name = "b";
  request.take = {"w"};
  const EditedModel& robot = bench.open("r.urdf");
  const std::string urdf = bench.text(robot, split(robot, "a", request));
  EXPECT_NE(
      urdf.find("  <gazebo reference=\"b\">\n    <material>Gazebo/Red</material>\n  </gazebo>\n"),
      std::string::npos)
      << urdf;
  request.share = SplitMass::kGiven;
  request.mass = 1;
  const EditedModel& model = bench.open("m.sdf");
  const std::string sdf = bench.text(model, split(model, "a", request));
  const std::size_t b = sdf.find("<link name=\"b\">");
  ASSERT_NE(b, std::string::npos);
  EXPECT_NE(sdf.find("<gravity>false</gravity>", b), std::string::npos) << sdf;
  EXPECT_NE(sdf.find("<linear>0.5</linear>", b), std::string::npos) << sdf;
}

TEST(Split, Refusals) {
  VerbBench bench({{"arm.urdf", kSplitMast}});
  const EditedModel& arm = bench.open("arm.urdf");
  SplitRequest request = mast_request();
  request.take = {"nothing"};
  EXPECT_EQ(split(arm, "arm", request).refused, "link 'arm' holds nothing that is named 'nothing'");
  request.take = {};
  request.name = "hand";
  EXPECT_EQ(split(arm, "arm", request).refused, "the name 'hand' is taken: choose one with --name");
  EXPECT_EQ(split(arm, "leg", request).refused, "no link is named 'leg'");
  request = mast_request();
  request.share = SplitMass::kGiven;
  request.mass = 5;
  EXPECT_EQ(split(arm, "arm", request).refused, "the new link can have a mass between 0 and 3 kg");
}

}  // namespace
}  // namespace rigor::author
