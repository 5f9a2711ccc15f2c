// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/compare.h>

#include <cmath>
#include <numbers>
#include <regex>

#include <robot/robots.h>

namespace rigor::test {
namespace {

using robot::Difference;
using robot::DifferenceKind;
using robot::Robot;
using Lines = std::vector<std::string>;

constexpr double kTiny = 1e-12;

/// What one change of a text makes differ.
std::vector<Difference> after(const std::string& text, const std::string& from,
                              const std::string& to) {
  return all_differences(text, with(text, from, to));
}

TEST(Robot, BodiesStandInTheFrameOfTheirJoint) {
  const Robot robot = robot_from(kArmSdf);
  ASSERT_EQ(robot.bodies.size(), 4U);
  const robot::Body& finger = robot.bodies[3];
  EXPECT_NEAR(finger.mass.com.x, 0, kTiny);  // 1 - 1, 2 - 2, 3 - 2.99
  EXPECT_NEAR(finger.mass.com.z, 0.01, kTiny);
  EXPECT_EQ(robot.joints[1].type, model::JointType::kRevolute);
  EXPECT_TRUE(std::isinf(robot.joints[1].axes[0].lower));
  EXPECT_TRUE(std::isinf(robot.joints[1].axes[0].effort));
  EXPECT_NEAR(robot.joints[2].axes[0].follow->offset, 0.02, kTiny);  // 0.07 - 0.5 · 0.1
}

/// By hand: a link of 2 m turned by 90° about z carries a joint that slides along x by 0.5 m.
TEST(Robot, ForwardKinematics) {
  const Robot robot = robot_from(R"(<robot name="r"><link name="a"/><link name="b"/><link name="c"/>
    <joint name="j" type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 0 5"/></joint>
    <joint name="k" type="prismatic"><origin xyz="2 0 0"/><parent link="b"/><child link="c"/>
      <axis xyz="3 0 0"/><limit lower="0" upper="1" effort="1" velocity="1"/></joint></robot>)");
  const auto X = body_poses(robot, {{std::numbers::pi / 2}, {0.5}});
  EXPECT_NEAR(X[2].translation.x, 0, kTiny);
  EXPECT_NEAR(X[2].translation.y, 2.5, kTiny);
}

TEST(Robot, NobodyMissesAnEmptyShape) {
  const auto ball = [](const std::string& shape) {
    return "<sdf version='1.9'><model name='m'><link name='a'>" + shape + "</link></model></sdf>";
  };
  const std::string empty =
      "<collision name='c'><geometry><empty/></geometry></collision>"
      "<visual name='v'><geometry><empty/></geometry></visual>";
  EXPECT_TRUE(all_differences(ball(empty), ball("")).empty());
  EXPECT_TRUE(all_differences(ball(""), ball(empty)).empty());
  const std::string sphere =
      "<collision name='c'><geometry><sphere><radius>1</radius></sphere></geometry></collision>";
  EXPECT_FALSE(all_differences(ball(sphere), ball(empty)).empty());
}

TEST(Robot, AScrewSlidesAsItTurns) {
  const std::string text = R"(<sdf version="1.11"><model name="m"><link name="a"/><link name="b"/>
    <joint name="j" type="screw"><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz></axis>
      <screw_thread_pitch>0.5</screw_thread_pitch></joint></model></sdf>)";
  const auto X = body_poses(robot_from(text), {{4 * std::numbers::pi}});
  EXPECT_NEAR(X[1].translation.z, 1, kTiny);  // two turns of half a meter
}

TEST(Robot, MomentsOfTwoPoints) {
  const Robot robot = robot_from(R"(<robot name="r"><link name="a"><inertial><mass value="2"/>
    <inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial></link>
    <link name="b"><inertial><origin xyz="0 0 1"/><mass value="3"/>
    <inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial></link>
    <joint name="j" type="fixed"><origin xyz="4 0 0"/><parent link="a"/><child link="b"/></joint>
    </robot>)");
  const robot::Moments sum = moments(robot, body_poses(robot, {}));
  EXPECT_EQ(sum.mass, 5);
  EXPECT_EQ(sum.first, (model::Vector3{12, 0, 3}));
  EXPECT_NEAR(sum.second.iyy, 3 * 17, kTiny);
  EXPECT_NEAR(sum.second.ixz, -3 * 4 * 1, kTiny);
}

TEST(Compare, ARobotIsItself) {
  EXPECT_EQ(told(all_differences(kArmUrdf, kArmUrdf)), Lines{});
  EXPECT_EQ(told(all_differences(kArmSdf, kArmSdf)), Lines{});
}

TEST(Compare, TheTwinInTheOtherFormatIsTheSame) {
  EXPECT_EQ(told(all_differences(kArmUrdf, kArmSdf)), Lines{});
  EXPECT_EQ(told(all_differences(kArmSdf, kArmUrdf)), Lines{});
}

TEST(Compare, AJointMovedByAMillimeter) {
  const auto found = after(kArmUrdf, "xyz=\"0 0 0.5\"", "xyz=\"0 0 0.501\"");
  ASSERT_EQ(told(found), Lines{"joint-moved joint elbow"});
  EXPECT_NEAR(found[0].distance, 0.001, kTiny);
  EXPECT_NEAR(found[0].angle, 0, kTiny);
}

TEST(Compare, AJointTurned) {
  const auto found = after(kArmUrdf, "rpy=\"0 0 0.5\"", "rpy=\"0 0 0.75\"");
  ASSERT_EQ(told(found), Lines{"joint-moved joint elbow"});
  EXPECT_NEAR(found[0].distance, 0, kTiny);
  EXPECT_NEAR(found[0].angle, 0.25, kTiny);
}

/// In SDF the links stay where they are when a joint's frame moves alone.
TEST(Compare, AJointMovedUnderItsLinks) {
  const std::string text = R"(<sdf version="1.9"><model name="m"><link name="a"/>
    <link name="b"><pose>0 0 1 0 0 0</pose><inertial><pose>0.1 0 0 0 0 0</pose><mass>1</mass></inertial>
      <collision name="c"><pose>0 0.5 0 0 0 0</pose><geometry><sphere><radius>1</radius></sphere></geometry></collision></link>
    <joint name="j" type="revolute"><pose>0 0 -0.5 0 0 0</pose><parent>a</parent><child>b</child>
      <axis><xyz>0 1 0</xyz></axis></joint></model></sdf>)";
  const auto found = after(text, "0 0 -0.5", "0 0 -0.502");
  ASSERT_EQ(told(found), Lines{"joint-moved joint j"});
  EXPECT_NEAR(found[0].distance, 0.002, kTiny);
}

TEST(Compare, NumbersComeWithFromAndTo) {
  const auto mass = after(kArmUrdf, "value=\"1.5\"", "value=\"1.75\"");
  ASSERT_EQ(told(mass), Lines{"mass link upper"});
  EXPECT_EQ(mass[0].from.numbers, std::vector<double>{1.5});
  EXPECT_EQ(mass[0].to.numbers, std::vector<double>{1.75});
  EXPECT_EQ(mass[0].unit, "kg");
  const auto upper = after(kArmUrdf, "upper=\"1.6\"", "upper=\"1e17\"");
  ASSERT_EQ(told(upper), Lines{"upper-limit joint shoulder"});
  EXPECT_TRUE(std::isinf(upper[0].to.numbers[0]));
  const auto speed = after(kArmUrdf, "velocity=\"0.3\"", "velocity=\"0.4\"");
  ASSERT_EQ(told(speed), Lines{"velocity joint slide"});
  EXPECT_EQ(speed[0].unit, "m/s");
}

TEST(Compare, OneThingIsOneDifference) {
  EXPECT_EQ(told(after(kArmUrdf, "0.48 0.6 0.64", "0.48 0.64 0.6")),
            Lines{"joint-axis joint shoulder"});
  EXPECT_EQ(told(after(kArmUrdf, "type=\"revolute\"", "type=\"fixed\"")),
            Lines{"joint-type joint shoulder"});
  EXPECT_EQ(told(after(kArmUrdf, "0.1 0.2 0.3\" rpy=\"0.4", "0.1 0.2 0.31\" rpy=\"0.4")),
            Lines{"collision-moved collision base/c"});
  EXPECT_EQ(told(after(kArmUrdf, "w.stl", "x.stl")), Lines{"mesh visual upper/w"});
  EXPECT_EQ(told(after(kArmUrdf, "0.1 0.2 0.8 0.9", "0.1 0.2 0.7 0.9")),
            Lines{"color visual upper/v"});
  EXPECT_EQ(told(after(kArmUrdf, "offset=\"0.02\"", "offset=\"0.03\"")),
            Lines{"mimic joint slide"});
  EXPECT_EQ(told(after(kArmUrdf, "<sphere radius=\"0.05\"/>", "<box size=\"1 1 1\"/>")),
            Lines{"shape collision fore/ball"});
  EXPECT_EQ(told(after(kArmUrdf, "xyz=\"0 0 0.4\" rpy=\"0.3", "xyz=\"0 0 0.5\" rpy=\"0.3")),
            Lines{"joint-moved joint flange"});
}

TEST(Compare, NewNames) {
  std::string renamed = kArmUrdf;
  for (int uses = 0; uses < 3; ++uses) renamed = with(renamed, "\"fore\"", "\"lower\"");
  renamed = with(renamed, "\"fore\"", "\"lower\"");
  EXPECT_EQ(told(all_differences(kArmUrdf, renamed)), Lines{"link-renamed link fore"});
  EXPECT_EQ(told(after(kArmUrdf, "joint name=\"shoulder\"", "joint name=\"yaw\"")),
            Lines{"joint-renamed joint shoulder"});
  EXPECT_EQ(told(after(kArmUrdf, "name=\"ball\"", "name=\"bowl\"")),
            Lines{"part-renamed collision fore/ball"});
}

TEST(Compare, LinksComeAndGo) {
  const std::string more = with(kArmUrdf, "</robot>", R"(
    <link name="cap"><inertial><mass value="0.2"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
    <joint name="screwed" type="fixed"><parent link="finger"/><child link="cap"/></joint></robot>)");
  EXPECT_EQ(
      told(all_differences(kArmUrdf, more)),
      (Lines{"link-only-in-b link cap", "joint-only-in-b joint screwed", "total-mass robot arm"}));
  EXPECT_EQ(
      told(all_differences(more, kArmUrdf)),
      (Lines{"link-only-in-a link cap", "joint-only-in-a joint screwed", "total-mass robot arm"}));
  const std::string frame = with(kArmUrdf, "</robot>", R"(<link name="eye"/>
    <joint name="e" type="fixed"><parent link="finger"/><child link="eye"/></joint></robot>)");
  EXPECT_EQ(told(all_differences(kArmUrdf, frame)),
            (Lines{"link-only-in-b link eye", "joint-only-in-b joint e"}));
  EXPECT_EQ(told(compare(robot_from(kArmUrdf), robot_from(frame))), Lines{});
}

/// Two bodies of 1 kg at ±1 m on a rod: 2 kg, about the middle 2 kg·m².
TEST(Compare, LumpingIsStructureAndNotMass) {
  const std::string parts = R"(<robot name="r"><link name="base"/><link name="a"><inertial>
    <origin xyz="1 0 0"/><mass value="1"/><inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/>
    </inertial></link><link name="b"><inertial><mass value="1"/>
    <inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial></link>
    <joint name="j" type="continuous"><parent link="base"/><child link="a"/><axis xyz="0 1 0"/></joint>
    <joint name="k" type="fixed"><origin xyz="-1 0 0"/><parent link="a"/><child link="b"/></joint>
    </robot>)";
  const std::string lump = R"(<robot name="r"><link name="base"/><link name="a"><inertial>
    <mass value="2"/><inertia ixx="0" ixy="0" ixz="0" iyy="2" iyz="0" izz="2"/></inertial></link>
    <joint name="j" type="continuous"><parent link="base"/><child link="a"/><axis xyz="0 1 0"/></joint>
    </robot>)";
  EXPECT_EQ(told(all_differences(parts, lump)),
            (Lines{"link-only-in-a link b", "joint-only-in-a joint k"}));
  EXPECT_EQ(told(all_differences(parts, with(lump, "izz=\"2\"", "izz=\"2.1\""))),
            (Lines{"inertia link a", "link-only-in-a link b", "joint-only-in-a joint k"}));
}

std::string with_joint(const std::string& joints) {
  return R"(<robot name="r"><link name="a"/><link name="b"><inertial><origin xyz="0.1 0.2 0.3"/><mass
    value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>)" +
         joints + "</robot>";
}

std::string sdf_with(const std::string& joint) {
  return R"(<sdf version="1.11"><model name="r"><link name="a"><inertial><mass>0</mass><inertia>
    <ixx>0</ixx><iyy>0</iyy><izz>0</izz></inertia></inertial></link><link name="b"><inertial>
    <pose>0.1 0.2 0.3 0 0 0</pose><mass>1</mass></inertial></link>)" +
         joint + "</model></sdf>";
}

constexpr const char* kEnds = "<parent>a</parent><child>b</child>";

/// A universal joint is two hinges, a ball three (z, y, x), a screw a hinge and a slider that follows.
TEST(Compare, SubstitutedJoints) {
  const auto hinge = [](const std::string& name, const std::string& parent,
                        const std::string& child, const std::string& axis) {
    return "<joint name=\"" + name + "\" type=\"continuous\"><parent link=\"" + parent +
           "\"/><child link=\"" + child + "\"/><axis xyz=\"" + axis + "\"/></joint>";
  };
  const Robot universal =
      robot_from(sdf_with(std::string("<joint name='j' type='universal'>") + kEnds +
                          "<axis><xyz>1 0 0</xyz></axis><axis2><xyz>0 1 0</xyz>"
                          "</axis2></joint>"));
  const std::string two =
      "<link name=\"mid\"/>" + hinge("j1", "a", "mid", "1 0 0") + hinge("j2", "mid", "b", "0 1 0");
  EXPECT_EQ(
      told(compare(universal, robot_from(with_joint(two)), {.joints = {{"j", {"j1", "j2"}}}})),
      Lines{});
  const std::string swapped =
      "<link name=\"mid\"/>" + hinge("j1", "a", "mid", "0 1 0") + hinge("j2", "mid", "b", "1 0 0");
  EXPECT_FALSE(
      compare(universal, robot_from(with_joint(swapped)), {.joints = {{"j", {"j1", "j2"}}}})
          .empty());
  const Robot ball =
      robot_from(sdf_with(std::string("<joint name='j' type='ball'>") + kEnds + "</joint>"));
  const std::string three = "<link name=\"m1\"/><link name=\"m2\"/>" +
                            hinge("z", "a", "m1", "0 0 1") + hinge("y", "m1", "m2", "0 1 0") +
                            hinge("x", "m2", "b", "1 0 0");
  EXPECT_EQ(
      told(compare(ball, robot_from(with_joint(three)), {.joints = {{"j", {"z", "y", "x"}}}})),
      Lines{});
  const Robot screw = robot_from(sdf_with(
      std::string("<joint name='j' type='screw'>") + kEnds +
      "<axis><xyz>0 0 1</xyz></axis><screw_thread_pitch>6.283185307179586</screw_thread_pitch>"
      "</joint>"));
  const auto thread = [&](const std::string& multiplier) {
    return with_joint("<link name=\"mid\"/>" + hinge("j", "a", "mid", "0 0 1") +
                      "<joint name=\"j_slide\" type=\"prismatic\"><parent link=\"mid\"/><child "
                      "link=\"b\"/><axis xyz=\"0 0 1\"/><limit lower=\"-1e16\" upper=\"1e16\" "
                      "effort=\"1\" velocity=\"1\"/><mimic joint=\"j\" multiplier=\"" +
                      multiplier + "\"/></joint>");
  };
  const robot::Correspondence names{.joints = {{"j", {"j", "j_slide"}}}};
  EXPECT_EQ(told(compare(screw, robot_from(thread("1")), names)), Lines{});
  EXPECT_FALSE(compare(screw, robot_from(thread("-1")), names).empty());
}

TEST(Compare, ALoopIsATreeAndAJoint) {
  const std::string loop = R"(<sdf version="1.9"><model name="m"><link name="a"/>
    <link name="b"><pose>1 0 0 0 0 0</pose></link><link name="c"><pose>0 1 0 0 0 0</pose></link>
    <joint name="ab" type="revolute"><parent>a</parent><child>b</child><axis/></joint>
    <joint name="ac" type="revolute"><parent>a</parent><child>c</child><axis/></joint>
    <joint name="bc" type="revolute"><pose>0.2 0 0 0 0 0</pose><parent>b</parent><child>c</child><axis/></joint>
    </model></sdf>)";
  const Robot robot = robot_from(loop);
  EXPECT_TRUE(robot.joints[2].closes_loop);
  EXPECT_EQ(told(all_differences(loop, loop)), Lines{});
  const auto found = after(loop, "0.2 0 0", "0.3 0 0");
  ASSERT_EQ(told(found), Lines{"joint-moved joint bc"});
  EXPECT_NEAR(found[0].distance, 0.1, kTiny);
  // Round in a cycle: it must end, and be itself.
  const std::string circle =
      with(loop, "<parent>a</parent><child>b</child>", "<parent>c</parent><child>a</child>");
  EXPECT_EQ(told(all_differences(circle, circle)), Lines{});
}

TEST(Compare, WhatIsFixedToTheWorld) {
  const std::string fixed = R"(<sdf version="1.9"><model name="m"><link name="a"/>
    <joint name="j" type="fixed"><parent>world</parent><child>a</child></joint></model></sdf>)";
  const std::string urdf = R"(<robot name="m"><link name="world"/><link name="a"><inertial><mass
    value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
    <joint name="j" type="fixed"><parent link="world"/><child link="a"/></joint></robot>)";
  EXPECT_EQ(told(all_differences(fixed, urdf)), Lines{});
  const std::string free = with(
      fixed, "<joint name=\"j\" type=\"fixed\"><parent>world</parent><child>a</child></joint>", "");
  EXPECT_EQ(told(compare(robot_from(fixed), robot_from(free))),
            (Lines{"link-only-in-a link world", "joint-only-in-a joint j"}));
}

TEST(Compare, PlacementIsToldWhenAsked) {
  const std::string text =
      "<sdf version=\"1.9\"><model name=\"m\"><pose>1 2 3 0 0 0</pose><static>"
      "0</static><link name=\"a\"><pose>0 0 1 0 0 0</pose></link></model></sdf>";
  EXPECT_EQ(told(after(text, "1 2 3", "1 2 4")), Lines{"model-pose robot m"});
  EXPECT_EQ(told(after(text, "0 0 1 ", "0 0 2 ")), Lines{"root-pose robot m"});
  EXPECT_EQ(told(after(text, "<static>0", "<static>1")), Lines{"static robot m"});
  EXPECT_EQ(told(compare(robot_from(text), robot_from(with(text, "1 2 3", "1 2 4")))), Lines{});
}

/// Each number of a fixture, changed alone, is found, from either side, and by as many differences.
void find_every_number(const std::string& text) {
  const std::regex number("[ \">](-?[0-9]+\\.?[0-9]*)(?=[ \"<])");
  const Robot original = robot_from(text);
  std::size_t changed = 0;
  const auto end = std::sregex_iterator();
  for (auto it = std::sregex_iterator(text.begin(), text.end(), number); it != end; ++it) {
    const auto at = static_cast<std::size_t>(it->position(1));
    const std::string line = text.substr(text.rfind('\n', at) + 1, at - text.rfind('\n', at) - 1);
    if (line.find("version") != std::string::npos) continue;
    const double value = std::stod((*it)[1]);
    // The length of an axis, the opacity of an ambient color, and -1 for no limit mean nothing.
    const auto in = [&line](const std::string& tag) {
      const std::size_t found = line.rfind(tag);
      return found != std::string::npos && line.find('<', found + tag.size()) == std::string::npos;
    };
    if ((in("<axis xyz=") || in("<axis><xyz>")) && std::abs(value) == 1) continue;
    if (in("<ambient>") && value == 1) continue;
    if (in("<effort>") && value == -1) continue;
    std::string mutated = text;
    mutated.replace(at, static_cast<std::size_t>(it->length(1)), std::to_string(value + 0.0625));
    const Robot other = robot_from(mutated);
    const robot::Correspondence all{.helpers = robot::Helpers::kReported,
                                    .placement = robot::Placement::kReported};
    const auto there = compare(original, other, all), back = compare(other, original, all);
    EXPECT_FALSE(there.empty()) << line << "[" << (*it)[1] << "]";
    EXPECT_EQ(there.size(), back.size()) << line << "[" << (*it)[1] << "]";
    EXPECT_LE(there.size(), 2U) << line << "[" << (*it)[1] << "]: one change, "
                                << testing::PrintToString(told(there));
    ++changed;
  }
  EXPECT_GT(changed, 80U);
}

TEST(Compare, EveryNumberOfAUrdfCounts) { find_every_number(kArmUrdf); }
TEST(Compare, EveryNumberOfAnSdfCounts) { find_every_number(kArmSdf); }

/// 1e-10 is below what is reported, 1e-8 above.
TEST(Compare, TheThresholdIsANanometer) {
  EXPECT_EQ(told(after(kArmUrdf, "xyz=\"0 0 0.5\"", "xyz=\"0 0 0.5000000001\"")), Lines{});
  EXPECT_EQ(told(after(kArmUrdf, "xyz=\"0 0 0.5\"", "xyz=\"0 0 0.50000001\"")),
            Lines{"joint-moved joint elbow"});
}

/// A chain of thousands ends, and one moved joint in it is one difference.
TEST(Compare, ALongChain) {
  std::string text = "<robot name=\"chain\"><link name=\"l0\"/>";
  for (int i = 1; i <= 3000; ++i) {
    const std::string n = std::to_string(i);
    text += "<link name=\"l" + n + "\"/><joint name=\"j" + n +
            "\" type=\"continuous\"><origin xyz=\"0 0 0.1\"/><parent link=\"l" +
            std::to_string(i - 1) + "\"/><child link=\"l" + n + "\"/></joint>";
  }
  text += "</robot>";
  EXPECT_EQ(told(all_differences(text, text)), Lines{});
  EXPECT_EQ(told(after(text, "0 0 0.1", "0 0 0.2")), Lines{"joint-moved joint j1"});
}

TEST(Compare, NumbersThatAreNone) {
  const std::string text = with(kArmUrdf, "xyz=\"0 0 0.5\"", "xyz=\"0 0 1e308\"");
  EXPECT_EQ(told(all_differences(text, text)), Lines{});
  EXPECT_FALSE(all_differences(kArmUrdf, text).empty());
}

}  // namespace
}  // namespace rigor::test
