// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// set-pose, set-limit and move-frame: what is written, and that nothing else moves.

#include <gtest/gtest.h>

#include <rigor/author/verbs/move_frame.h>
#include <rigor/author/verbs/set_value.h>

#include "author/verbs/verb_bench.h"

namespace rigor::author {
namespace {

constexpr const char* kCart = R"(<robot name="cart">
  <link name="bed">
    <inertial>
      <origin xyz="0 0 0.5"/>
      <mass value="2"/>
      <inertia ixx="0.2" iyy="0.2" izz="0.1" ixy="0" ixz="0" iyz="0"/>
    </inertial>
    <visual><geometry><box size="1 1 1"/></geometry></visual>
  </link>
  <joint name="axle" type="continuous">
    <origin xyz="0 0.5 0" rpy="-1.5707963267948966 0 0"/>
    <parent link="bed"/> <child link="wheel"/>
    <axis xyz="0 0 1"/>
  </joint>
  <link name="wheel">
    <visual><geometry><cylinder radius="0.1" length="0.05"/></geometry></visual>
  </link>
  <joint name="mast" type="revolute">
    <parent link="bed"/> <child link="flag"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint>
  <link name="flag"/>
</robot>
)";

std::string with_change(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(SetPose, OfAJointOrWhatItCarries) {
  VerbBench bench({{"cart.urdf", kCart}});
  const EditedModel& cart = bench.open("cart.urdf");
  const std::string expected = with_change(kCart, "xyz=\"0 0.5 0\"", "xyz=\"0 0.25 0\"");
  const model::Pose X{{0, 0.25, 0}, model::from_rpy(-1.5707963267948966, 0, 0)};
  EXPECT_EQ(bench.text(cart, with_pose(cart, "axle", X)), expected);
  EXPECT_EQ(bench.text(cart, with_pose(cart, "wheel", X)), expected);
  EXPECT_EQ(with_pose(cart, "bed", X).refused, "nothing that has a pose is named 'bed'");
}

TEST(SetLimit, WhereItIsWrittenAndWhereItIsNot) {
  VerbBench bench({{"cart.urdf", kCart},
                   {"m.sdf", R"(<sdf version="1.9"><model name="m"><link name="a"/><link name="b"/>
  <joint name="j" type="revolute">
    <parent>a</parent><child>b</child>
    <axis>
      <xyz>0 0 1</xyz>
    </axis>
  </joint>
</model></sdf>
)"}});
  const EditedModel& cart = bench.open("cart.urdf");
  EXPECT_EQ(bench.text(cart, with_limits(cart, "mast", {.lower = -0.5, .effort = 20})),
            with_change(kCart, R"(lower="-1" upper="1" effort="1")",
                        R"(lower="-0.5" upper="1" effort="20")"));
  EXPECT_EQ(bench.text(cart, with_limits(cart, "axle", {.effort = 2, .velocity = 3})),
            with_change(kCart, "    <axis xyz=\"0 0 1\"/>\n",
                        "    <axis xyz=\"0 0 1\"/>\n    <limit effort=\"2\" velocity=\"3\"/>\n"));
  EXPECT_EQ(with_limits(cart, "axle", {.lower = 0}).refused,
            "joint 'axle' is continuous: it has no lower or upper limit");
  const EditedModel& model = bench.open("m.sdf");
  const std::string text = bench.text(model, with_limits(model, "j", {.lower = -1, .upper = 2}));
  EXPECT_NE(text.find("      <limit>\n        <lower>-1</lower>\n        <upper>2</upper>\n"),
            std::string::npos)
      << text;
}

TEST(SetLimit, WhatNoJointCanHaveIsRefused) {
  VerbBench bench({{"r.urdf", R"(<robot name="r">
  <link name="a"/><link name="b"/><link name="c"/><link name="d"/>
  <joint name="axle" type="continuous"><parent link="a"/><child link="b"/></joint>
  <joint name="free" type="floating"><parent link="a"/><child link="c"/></joint>
  <joint name="elbow" type="revolute">
    <parent link="a"/><child link="d"/>
    <limit effort="1" velocity="1" upper="1"/>
  </joint>
</robot>
)"}});
  const EditedModel& robot = bench.open("r.urdf");
  EXPECT_EQ(with_limits(robot, "axle", {.effort = 5}).refused,
            "the <limit> of joint 'axle' needs effort and velocity: give --velocity, too");
  EXPECT_EQ(with_limits(robot, "free", {.effort = 5, .velocity = 1}).refused,
            "joint 'free' is floating, and has no limits");
  EXPECT_EQ(with_limits(robot, "elbow", {.lower = 2}).refused,
            "the lower limit 2 of joint 'elbow' would exceed the upper limit 1: give --upper, too");
  // URDF's lower limit is 0 where it is not written.
  EXPECT_EQ(
      with_limits(robot, "elbow", {.upper = -1}).refused,
      "the lower limit 0 of joint 'elbow' would exceed the upper limit -1: give --lower, too");
  EXPECT_EQ(with_limits(robot, "elbow", {.effort = -5}).refused,
            "a limit of effort or velocity is not below 0");
  EXPECT_EQ(with_limits(robot, "elbow", {.lower = -1}).refused, "");
}

TEST(MoveFrame, OfARootToItsCenterOfMass) {
  VerbBench bench({{"cart.urdf", kCart}});
  const EditedModel& cart = bench.open("cart.urdf");
  const auto X = frame_at(cart, "bed", FramePlace::kCenterOfMass);
  ASSERT_TRUE(X);
  EXPECT_EQ(X->translation, (model::Vector3{0, 0, 0.5}));
  const std::string text = bench.text(cart, with_frame(cart, "bed", *X));
  EXPECT_NE(text.find("<origin xyz=\"0 0 0\"/>\n      <mass"), std::string::npos) << text;
  EXPECT_NE(text.find("<origin xyz=\"0 0.5 -0.5\" rpy=\"-1.5707963267948966 0 0\"/>"),
            std::string::npos);
  const EditedModel& moved = bench.open_text("cart.urdf", text);
  const std::string back = bench.text(moved, with_frame(moved, "bed", inverse(*X)));
  EXPECT_EQ(VerbBench::words(
                differences_at_rounding(cart.robot, bench.open_text("cart.urdf", back).robot)),
            "");
}

TEST(MoveFrame, OfAUrdfsLinkAlongItsAxisOnly) {
  VerbBench bench({{"cart.urdf", kCart}});
  const EditedModel& cart = bench.open("cart.urdf");
  const std::string text = bench.text(cart, with_frame(cart, "wheel", {{0, 0, 0.5}, {}}));
  EXPECT_NE(text.find("<origin xyz=\"0 1 0\" rpy=\"-1.5707963267948966 0 0\"/>"), std::string::npos)
      << text;
  EXPECT_EQ(with_frame(cart, "wheel", {{0.1, 0, 0}, {}}).refused,
            "the frame would leave the axis of joint 'axle'");
}

TEST(MoveFrame, OfAnSdfLinkToItsJoint) {
  constexpr const char* kSdf = R"(<sdf version="1.9"><model name="m">
  <link name="a"/>
  <link name="b">
    <pose>1 0 0 0 0 0</pose>
    <visual name="v"><geometry><box><size>1 1 1</size></box></geometry></visual>
  </link>
  <link name="c"><pose relative_to="b">0 0 1 0 0 0</pose></link>
  <joint name="j" type="fixed"><pose>-0.5 0 0 0 0 0</pose><parent>a</parent><child>b</child></joint>
  <joint name="k" type="fixed"><parent>b</parent><child>c</child></joint>
</model></sdf>
)";
  VerbBench bench({{"m.sdf", kSdf}});
  const EditedModel& model = bench.open("m.sdf");
  const auto X = frame_at(model, "b", FramePlace::kJoint);
  ASSERT_TRUE(X);
  const ProvenChange proven = bench.prove(model, with_frame(model, "b", *X));
  ASSERT_TRUE(proven.holds()) << VerbBench::words(proven.unasked);
  // The joints are where they were; the mass that SDF defaults to is not.
  EXPECT_EQ(frame_at(model, "b", FramePlace::kCenterOfMass), std::nullopt);
  const robot::Robot& after = proven.after->robot;
  EXPECT_EQ(after.joints[0].X_PJ.translation, (model::Vector3{0.5, 0, 0}));
  EXPECT_EQ(model.robot.bodies[1].mass.com, (model::Vector3{0.5, 0, 0}));
  EXPECT_EQ(after.bodies[1].mass.com, (model::Vector3{0, 0, 0}));
  EXPECT_EQ(proven.files.at(0).text, R"(<sdf version="1.9"><model name="m">
  <link name="a"/>
  <link name="b">
    <pose>0.5 0 0 0 0 0</pose>
    <visual name="v"><pose>0.5 0 0 0 0 0</pose><geometry><box><size>1 1 1</size></box></geometry></visual>
  </link>
  <link name="c"><pose relative_to="b">0.5 0 1 0 0 0</pose></link>
  <joint name="j" type="fixed"><pose>0 0 0 0 0 0</pose><parent>a</parent><child>b</child></joint>
  <joint name="k" type="fixed"><parent>b</parent><child>c</child></joint>
</model></sdf>
)");
}

}  // namespace
}  // namespace rigor::author
