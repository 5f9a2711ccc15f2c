// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Gearboxes as joints that follow others. In SDF's words: the angle from the reference body to the child is
// -ratio times the angle from it to the parent, each about the gearbox's axis for it.

#include <gtest/gtest.h>

#include <string>

#include <robot/robots.h>

namespace rigor::test {
namespace {

std::string wheel_joint(const std::string& name, const std::string& parent,
                        const std::string& child, const std::string& axis) {
  return "<joint name='" + name + "' type='revolute'><parent>" + parent + "</parent><child>" +
         child + "</child><axis><xyz>" + axis + "</xyz></axis></joint>";
}

/// Wheels a and b in a frame; the gearbox, which is written first, is between them.
std::string geared_wheels(const std::string& ratio, const std::string& first,
                          const std::string& second, const std::string& inside = "") {
  return "<sdf version='1.8'><model name='m'><link name='frame'/><link name='a'/>"
         "<link name='b'><pose>0 1 0 0 0 0</pose></link>"
         "<joint name='g' type='gearbox'><parent>a</parent><child>b</child>"
         "<axis><xyz expressed_in='__model__'>0 0 1</xyz></axis>"
         "<axis2><xyz expressed_in='__model__'>0 0 1</xyz></axis2><gearbox_ratio>" +
         ratio + "</gearbox_ratio><gearbox_reference_body>frame</gearbox_reference_body></joint>" +
         first + second + inside + "</model></sdf>";
}

/// At the angle of joint i, with what follows it.
double followed_angle(const robot::Robot& robot, double angle_of_i) {
  const robot::Positions positions = robot::followed(robot, {{angle_of_i}, {0}, {0}});
  return positions[1][0];
}

TEST(Gearbox, TheChildTurnsRatioTimesAgainstTheParent) {
  const robot::Robot robot = robot_from(geared_wheels("3", wheel_joint("i", "frame", "a", "0 0 1"),
                                                      wheel_joint("j", "frame", "b", "0 0 1")));
  ASSERT_EQ(robot.joints.size(), 3U);
  EXPECT_TRUE(robot.joints[2].closes_loop);  // it carries nothing, although it stands first
  EXPECT_EQ(robot.bodies[robot.joints[1].child].name, "b");
  EXPECT_DOUBLE_EQ(followed_angle(robot, 0.2), -0.6);
}

TEST(Gearbox, JointsThatCountBackwards) {
  // θ_b = -3 θ_a; joint j turns about -z, so its angle is -θ_b.
  EXPECT_DOUBLE_EQ(
      followed_angle(robot_from(geared_wheels("3", wheel_joint("i", "frame", "a", "0 0 1"),
                                              wheel_joint("j", "frame", "b", "0 0 -1"))),
                     0.2),
      0.6);
  // Joint i leads from the wheel to the frame: its angle is -θ_a.
  EXPECT_DOUBLE_EQ(
      followed_angle(robot_from(geared_wheels("3", wheel_joint("i", "a", "frame", "0 0 1"),
                                              wheel_joint("j", "frame", "b", "0 0 1"))),
                     0.2),
      0.6);
}

TEST(Gearbox, ARightAngleWithTwoDecimalsIsOne) {
  const robot::Robot robot = robot_from(geared_wheels(
      "3", wheel_joint("i", "frame", "a", "0 0 1"), wheel_joint("j", "frame", "b", "0.0008 0 1")));
  EXPECT_DOUBLE_EQ(followed_angle(robot, 0.2), -0.6);
}

TEST(Gearbox, WhatCouplesNoTwoHingesLetsNothingFollow) {
  const std::string i = wheel_joint("i", "frame", "a", "0 0 1"),
                    j = wheel_joint("j", "frame", "b", "0 0 1");
  const auto turned = [](const std::string& text) { return followed_angle(robot_from(text), 1); };
  EXPECT_EQ(turned(geared_wheels("3", i, wheel_joint("j", "frame", "b", "1 0 0"))), 0);  // skew
  EXPECT_EQ(turned(geared_wheels("0", i, j)), 0);
  EXPECT_EQ(turned(with(geared_wheels("3", i, j), ">frame</gearbox", ">a</gearbox")), 0);
  const std::string follower =
      with(j, "</xyz></axis>", "</xyz><mimic joint='i'><multiplier>2</multiplier></mimic></axis>");
  EXPECT_EQ(turned(geared_wheels("3", i, follower)), 2);
  const std::string ring =
      with(i, "</xyz></axis>", "</xyz><mimic joint='j'><multiplier>2</multiplier></mimic></axis>");
  EXPECT_FALSE(robot_from(geared_wheels("3", ring, j)).joints[1].axes[0].follow);
}

TEST(Gearbox, AMimicMovesTheSame) {
  const std::string i = wheel_joint("i", "frame", "a", "0 0 1"),
                    j = wheel_joint("j", "frame", "b", "0 0 1");
  const std::string geared = geared_wheels("3", i, j);
  std::string mimicked = geared;
  const std::size_t begin = mimicked.find("<joint name='g'"),
                    end = mimicked.find("</joint>", begin);
  mimicked.erase(begin, end + 8 - begin);
  mimicked = with(mimicked, "<parent>frame</parent><child>b</child><axis><xyz>0 0 1</xyz>",
                  "<parent>frame</parent><child>b</child><axis><xyz>0 0 1</xyz>"
                  "<mimic joint='i'><multiplier>-3</multiplier><offset>0</offset>"
                  "<reference>0</reference></mimic>");
  mimicked = with(mimicked, "1.8", "1.11");
  EXPECT_EQ(told(all_differences(geared, mimicked)),
            std::vector<std::string>{"joint-only-in-a joint g"});
}

}  // namespace
}  // namespace rigor::test
