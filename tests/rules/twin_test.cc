// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Rules on parts that are made alike: what counts as the same, who confirms whom, and how loudly a rule speaks.

#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>

namespace rigor::rules {
namespace {

/// Of one rule in a robot.
std::vector<Diagnostic> twin_findings(const std::string& rule, const std::string& text) {
  const MemoryDisk disk(std::map<std::string, std::string>{{"a.urdf", text}});
  const Environment environment(disk, {});
  Sources sources;
  std::vector<Diagnostic> found;
  const ValidateResult result = validate(environment, {.paths = {"a.urdf"}}, sources);
  for (const Diagnostic& diagnostic : result.diagnostics.list()) {
    if (diagnostic.rule == rule) found.push_back(diagnostic);
  }
  return found;
}

struct TwinFinger {
  std::string name;
  std::string mass = "0.1";
  std::string origin = "0.02 0.03 0.1";
  std::string limits = "lower='-0.2' upper='1.4'";
};

std::string twin_hand(const std::vector<TwinFinger>& fingers) {
  std::string text = "<robot name='hand'><link name='palm'/>";
  for (const TwinFinger& finger : fingers) {
    text += "<link name='" + finger.name + "'><inertial><origin xyz='0 0.004 0.02'/><mass value='" +
            finger.mass +
            "'/><inertia ixx='2e-5' ixy='0' ixz='0' iyy='2e-5' iyz='0' "
            "izz='1e-5'/></inertial></link><joint name='" +
            finger.name + "_joint' type='revolute'><parent link='palm'/><child link='" +
            finger.name + "'/><origin xyz='" + finger.origin + "'/><axis xyz='0 1 0'/><limit " +
            finger.limits + " effort='1' velocity='2'/></joint>";
  }
  return text + "</robot>";
}

TEST(Twin, IsTheSameWithOtherSigns) {
  const std::string rule = "twin-value-differs";
  EXPECT_TRUE(twin_findings(rule, twin_hand({{"left"}, {"right"}})).empty());
  EXPECT_TRUE(
      twin_findings(rule, twin_hand({{"left"}, {.name = "right", .origin = "0.02 -0.03 0.1"}}))
          .empty());
  // A range of motion is mirrored by its signs and order.
  EXPECT_TRUE(
      twin_findings(rule,
                    twin_hand({{"left"}, {.name = "right", .limits = "lower='-1.4' upper='0.2'"}}))
          .empty());
}

TEST(Twin, DiffersByMoreThanACalibration) {
  const std::string rule = "twin-value-differs";
  EXPECT_TRUE(
      twin_findings(rule, twin_hand({{"left"}, {.name = "right", .mass = "0.1005"}})).empty());
  EXPECT_TRUE(
      twin_findings(rule, twin_hand({{"left"}, {.name = "right", .mass = "0.103"}})).empty());
  EXPECT_EQ(twin_findings(rule, twin_hand({{"left"}, {.name = "right", .mass = "0.2"}})).size(),
            1U);
  EXPECT_EQ(
      twin_findings(rule, twin_hand({{"left"}, {.name = "right", .origin = "0.02 -0.03 0.12"}}))
          .size(),
      1U);
  EXPECT_EQ(
      twin_findings(rule,
                    twin_hand({{"left"}, {.name = "right", .limits = "lower='-0.2' upper='1.8'"}}))
          .size(),
      1U);
}

TEST(Twin, IsNoneWithMoreThanOneDifference) {
  // The links differ in their mass; their joints in their origins, too.
  const auto found =
      twin_findings("twin-value-differs",
                    twin_hand({{"left"}, {.name = "right", .mass = "0.2", .origin = "0 0 0.1"}}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found.front().message.find("mass"), std::string::npos);
}

TEST(Twin, OfManyFingersTheOddOneIsReportedAndMended) {
  const auto found = twin_findings(
      "twin-value-differs",
      twin_hand({{"finger_1"}, {"finger_2"}, {.name = "finger_3", .mass = "0.15"}, {"finger_4"}}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found.front().subject.find("finger_3"), std::string::npos);
  ASSERT_FALSE(found.front().fixes.empty());
  EXPECT_EQ(found.front().fixes.front().edits.front().text, "0.1");
}

/// Sensors along a bumper, counted from one side: each name's twin is one place further.
TEST(Twin, IsAnotherPartWhereOneOfAnotherNameIsTheMirrorImage) {
  const std::string rule = "twin-value-differs";
  const TwinFinger left{.name = "left", .origin = "0.10 0.12 0.1"};
  const TwinFinger right{.name = "right", .origin = "0.04 -0.15 0.1"};
  const TwinFinger side{.name = "side_left", .origin = "0.04 0.15 0.1"};
  EXPECT_EQ(twin_findings(rule, twin_hand({left, right})).size(), 1U);
  EXPECT_TRUE(twin_findings(rule, twin_hand({left, right, side})).empty());
  // A part at the place of the twin's is not its image.
  const TwinFinger beside{.name = "wrist", .origin = "0.04 -0.15 0.1"};
  EXPECT_EQ(twin_findings(rule, twin_hand({left, right, beside})).size(), 1U);
}

TEST(Twin, NumberedPartsWithoutAMajorityAreNoTwins) {
  EXPECT_TRUE(twin_findings("twin-value-differs",
                            twin_hand({{"finger_1"}, {.name = "finger_2", .mass = "0.2"}}))
                  .empty());
  EXPECT_TRUE(twin_findings("twin-value-differs", twin_hand({{"finger_1"},
                                                             {"finger_2"},
                                                             {.name = "finger_3", .mass = "0.2"},
                                                             {.name = "finger_4", .mass = "0.2"}}))
                  .empty());
}

struct TwinLeg {
  std::string name;
  std::string origin;
  std::string axis = "0 1 0";
};

/// TwinLegs of one joint each, with a range that is not symmetric.
std::string twin_legs(const std::vector<TwinLeg>& all) {
  std::string text = "<robot name='legs'><link name='body'/>";
  for (const TwinLeg& leg : all) {
    text += "<link name='" + leg.name + "'/><joint name='" + leg.name +
            "_joint' type='revolute'><parent link='body'/><child link='" + leg.name +
            "'/><origin xyz='" + leg.origin + "'/><axis xyz='" + leg.axis +
            "'/><limit lower='-0.5' upper='1.5' effort='9' velocity='9'/></joint>";
  }
  return text + "</robot>";
}

TEST(Twin, AxesOfBothSidesMayBeTheSameOrMirrored) {
  const std::string rule = "twin-axis-opposed";
  EXPECT_TRUE(
      twin_findings(
          rule, twin_legs({{"FL", "1 1 0"}, {"FR", "1 -1 0"}, {"RL", "-1 1 0"}, {"RR", "-1 -1 0"}}))
          .empty());
  EXPECT_TRUE(twin_findings(rule, twin_legs({{"FL", "1 1 0"},
                                             {"FR", "1 -1 0", "0 -1 0"},
                                             {"RL", "-1 1 0"},
                                             {"RR", "-1 -1 0", "0 -1 0"}}))
                  .empty());
}

TEST(Twin, AnAxisThatThreeLegsDoNotHaveIsMended) {
  const auto found = twin_findings(
      "twin-axis-opposed",
      twin_legs(
          {{"FL", "1 1 0"}, {"FR", "1 -1 0"}, {"RL", "-1 1 0", "0 -1 0"}, {"RR", "-1 -1 0"}}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found.front().subject.find("RL"), std::string::npos);
  ASSERT_FALSE(found.front().fixes.empty());
  EXPECT_EQ(found.front().fixes.front().edits.front().text, "0 1 0");
}

}  // namespace
}  // namespace rigor::rules
