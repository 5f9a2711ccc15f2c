// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a conversion changes on purpose is no difference, and what it must not change is one: pairs of
// robots written by hand.

#include <gtest/gtest.h>

#include <robot/robots.h>

namespace rigor::test {
namespace {

using robot::Correspondence;
using Lines = std::vector<std::string>;

Lines told_with(const std::string& a, const std::string& b, const Correspondence& names) {
  return told(compare(robot_from(a), robot_from(b), names));
}

const std::string kPair = R"(<robot name="r">
<link name="a"><inertial><mass value="1"/>
  <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
  <visual><geometry><sphere radius="0.5"/></geometry></visual></link>
<link name="b"><inertial><mass value="3"/>
  <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
  <collision><origin xyz="0 0 1"/><geometry><box size="1 2 3"/></geometry></collision></link>
<link name="c"><inertial><mass value="2"/>
  <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
<joint name="ab" type="fixed"><origin xyz="4 0 0"/><parent link="a"/><child link="b"/></joint>
<joint name="bc" type="revolute"><origin xyz="0 1 0"/><parent link="b"/><child link="c"/>
  <axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="5" velocity="2"/></joint>
</robot>)";

/// 1 kg at 0 and 3 kg at x = 4 are 4 kg at x = 3, and about that 1·9 + 3·1 = 12 more than 2.
const std::string kLumped = R"(<sdf version="1.9"><model name="r">
<link name="a"><inertial><pose>3 0 0 0 0 0</pose><mass>4</mass>
  <inertia><ixx>2</ixx><iyy>14</iyy><izz>14.0</izz></inertia></inertial>
  <visual name="v"><geometry><sphere><radius>0.5</radius></sphere></geometry></visual>
  <collision name="k"><pose>4 0 1 0 0 0</pose>
    <geometry><box><size>1 2 3</size></box></geometry></collision></link>
<frame name="b" attached_to="a"><pose>4 0 0 0 0 0</pose></frame>
<link name="c"><pose relative_to="bc"/><inertial><mass>2</mass></inertial></link>
<joint name="bc" type="revolute"><pose relative_to="a">4 1 0 0 0 0</pose>
  <parent>a</parent><child>c</child><axis><xyz>0 0 1</xyz><limit><lower>-1</lower><upper>1</upper>
  <effort>5</effort><velocity>2</velocity></limit></axis></joint>
</model></sdf>)";

TEST(CompareHeld, ALumpedLinkIsPartOfWhatCarriesIt) {
  const Correspondence names{.held_by = {{"b", "a"}}};
  EXPECT_EQ(told_with(kPair, kLumped, names), Lines{});
  EXPECT_EQ(told_with(kPair, kPair, names), Lines{}) << "not lumped";
  EXPECT_FALSE(told_with(kPair, kLumped, {}).empty()) << "nobody meant to lump";
}

TEST(CompareHeld, AMistakeInLumpingIsFound) {
  const auto mistaken = [](const std::string& from, const std::string& to) {
    return told_with(kPair, with(kLumped, from, to), {.held_by = {{"b", "a"}}});
  };
  EXPECT_EQ(mistaken("<mass>4", "<mass>1"), Lines{"mass link a"});
  EXPECT_EQ(mistaken("<pose>3 0 0 ", "<pose>2 0 0 "), Lines{"center-of-mass link a"});
  EXPECT_EQ(mistaken("<izz>14.0", "<izz>2"), Lines{"inertia link a"});
  EXPECT_EQ(mistaken("<pose>4 0 1 ", "<pose>0 0 1 "), Lines{"collision-moved collision a/1"});
  EXPECT_EQ(mistaken("1 2 3", "3 2 1"), Lines{"size collision a/1"});
  EXPECT_EQ(mistaken("4 1 0", "0 1 0"), Lines{"joint-moved joint bc"});
  EXPECT_EQ(mistaken("<pose>4 0 0 ", "<pose>0 0 0 "), Lines{"frame-moved frame b"});
}

TEST(CompareHeld, WhatMovesIsNotLumped) {
  const Correspondence names{.held_by = {{"c", "a"}}};
  EXPECT_EQ(told_with(kPair, kPair, names), Lines{});
  const std::string without_c = with(kPair, "name=\"c\"", "name=\"d\"");
  EXPECT_FALSE(told_with(kPair, with(without_c, "link=\"c\"", "link=\"d\""), names).empty());
}

/// A root is held by what is fixed to it: b stands at the origin of a turned by 4 m.
TEST(CompareHeld, ARootIsHeldByItsHeir) {
  const std::string urdf = R"(<robot name="r">
<link name="a"><visual><geometry><sphere radius="0.5"/></geometry></visual></link>
<link name="b"><inertial><mass value="3"/>
  <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
<joint name="ab" type="fixed"><origin xyz="4 0 0"/><parent link="a"/><child link="b"/></joint>
</robot>)";
  const std::string sdf =
      R"(<sdf version="1.9"><model name="r"><link name="b"><pose>4 0 0 0 0 0</pose>
<inertial><mass>3</mass></inertial><visual name="v"><pose>-4 0 0 0 0 0</pose>
<geometry><sphere><radius>0.5</radius></sphere></geometry></visual></link>
<frame name="a" attached_to="b"><pose>-4 0 0 0 0 0</pose></frame></model></sdf>)";
  const Correspondence names{.held_by = {{"a", "b"}}};
  EXPECT_EQ(told_with(urdf, sdf, names), Lines{});
  EXPECT_EQ(told_with(urdf, with(sdf, "frame name=\"a\"", "frame name=\"c\""), names),
            (Lines{"frame-only-in-a frame a", "frame-only-in-b frame c"}));
  EXPECT_EQ(told_with(urdf, with(sdf, "<pose>-4", "<pose>4"), names),
            Lines{"visual-moved visual b/1"});
}

TEST(CompareChosen, TheModelsPoseIsInTheJointsOnTheWorld) {
  const std::string sdf = R"(<sdf version="1.9"><model name="m"><pose>0 0 2 0 0 0</pose>
<link name="a"><pose>1 0 0 0 0 0</pose></link></model></sdf>)";
  const std::string urdf = R"(<robot name="m"><link name="world"/><link name="a"><inertial><mass
value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
<joint name="j" type="fixed"><origin xyz="1 0 2"/><parent link="world"/><child link="a"/></joint>
</robot>)";
  const Correspondence names{.from_world = true};
  EXPECT_EQ(told_with(sdf, urdf, names), Lines{});
  EXPECT_EQ(told_with(sdf, with(urdf, "1 0 2", "1 0 0"), names).size(), 1U);
  const std::string hung = with(sdf, "</model>",
                                "<joint name=\"j\" type=\"fixed\"><parent>world</parent>"
                                "<child>a</child></joint></model>");
  EXPECT_EQ(told_with(hung, urdf, names), Lines{});
  EXPECT_EQ(told_with(hung, with(urdf, "1 0 2", "1 0 0"), names), Lines{"joint-moved joint j"});
}

TEST(CompareChosen, ANumberStandsForNoLimit) {
  const std::string none = with(kPair, "effort=\"5\"", "effort=\"inf\"");
  const std::string number = with(kPair, "effort=\"5\"", "effort=\"1000\"");
  EXPECT_EQ(told_with(none, number, {}), Lines{"effort joint bc"});
  EXPECT_EQ(told_with(none, number, {.unlimited = 1000}), Lines{});
  EXPECT_EQ(told_with(none, number, {.unlimited = 999}), Lines{"effort joint bc"});
  EXPECT_EQ(told_with(kPair, number, {.unlimited = 1000}), Lines{"effort joint bc"});
}

/// SDF has no link without mass: what a tenth of a microgram weighs a meter away is nothing.
TEST(CompareChosen, NextToNothingMayStandAnywhere) {
  const std::string urdf = R"(<robot name="v"><link name="base"><inertial><mass value="5"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link><link name="cover">
<visual><geometry><sphere radius="1"/></geometry></visual></link><joint name="j" type="fixed">
<origin xyz="0 0 1"/><parent link="base"/><child link="cover"/></joint></robot>)";
  const std::string sdf = R"(<sdf version="1.9"><model name="v"><link name="base"><inertial>
<mass>5</mass></inertial></link><link name="cover"><pose relative_to="j"/><inertial>
<mass>1e-10</mass><inertia><ixx>1e-12</ixx><iyy>1e-12</iyy><izz>1e-12</izz></inertia></inertial>
<visual name="v"><geometry><sphere><radius>1</radius></sphere></geometry></visual></link>
<joint name="j" type="fixed"><pose relative_to="base">0 0 1 0 0 0</pose><parent>base</parent>
<child>cover</child></joint></model></sdf>)";
  EXPECT_EQ(told_with(urdf, sdf, {}), Lines{});
  EXPECT_FALSE(told_with(urdf, with(sdf, "1e-10", "1e-6"), {}).empty());
}

}  // namespace
}  // namespace rigor::test
