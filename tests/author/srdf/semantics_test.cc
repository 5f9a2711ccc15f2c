// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Groups of robots whose structure is drawn here, and an SRDF's matrix brought up to date.

#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/author/srdf/semantics.h>
#include <rigor/author/srdf/srdf_text.h>
#include <rigor/text/edit.h>

#include <robot/robots.h>

namespace rigor::test {
namespace {

/// Links are made of the joints' ends. A line a joint: name, type, parent, child, x of its origin.
struct DrawnJoint {
  std::string name, type, parent, child;
  std::string x = "0";
  std::string rest = "<limit lower='-1' upper='1' effort='1' velocity='1'/>";
};

std::string drawn(const std::vector<DrawnJoint>& joints) {
  std::string text;
  std::set<std::string> links;
  for (const DrawnJoint& joint : joints) {
    links.insert({joint.parent, joint.child});
    text += "<joint name='" + joint.name + "' type='" + joint.type + "'><origin xyz='" + joint.x +
            " 0 0'/><parent link='" + joint.parent + "'/><child link='" + joint.child + "'/>" +
            (joint.type == "fixed" ? "" : "<axis xyz='0 0 1'/>" + joint.rest) + "</joint>";
  }
  for (const std::string& link : links) {
    text += "<link name='" + link + "'>";
    if (link != "world" && !link.ends_with("_frame"))
      text += "<collision><geometry><sphere radius='0.01'/></geometry></collision>";
    text += "</link>";
  }
  return "<robot name='r'>" + text + "</robot>";
}

std::vector<std::string> group_lines(const author::Semantics& semantics) {
  std::vector<std::string> lines;
  for (const auto& group : semantics.groups) {
    std::string line = group.name + ':';
    if (!group.tip_link.empty()) line += ' ' + group.base_link + ".." + group.tip_link;
    for (const std::string& link : group.links) line += ' ' + link;
    lines.push_back(line);
  }
  return lines;
}

using Lines = std::vector<std::string>;

TEST(Semantics, OfAnArmWithAGripper) {
  const author::Semantics semantics = author::semantics_of(robot_from(
      drawn({{"w", "fixed", "world", "base"},
             {"j1", "revolute", "base", "l1", "0.3"},
             {"j2", "revolute", "l1", "l2", "0.3"},
             {"j3", "revolute", "l2", "l3", "0.3",
              "<limit lower='1' upper='2' effort='1' velocity='1'/>"},
             {"flange", "fixed", "l3", "tool_frame", "0.1"},
             {"mount", "fixed", "tool_frame", "hand"},
             {"f1", "prismatic", "hand", "left", "0.1"},
             {"f2", "prismatic", "hand", "right", "0.1",
              "<limit lower='-1' upper='1' effort='1' velocity='1'/><mimic joint='f1'/>"}})));
  EXPECT_EQ(group_lines(semantics), (Lines{"arm: base..tool_frame", "gripper: hand left right"}));
  ASSERT_EQ(semantics.end_effectors.size(), 1U);
  EXPECT_EQ(semantics.end_effectors[0].parent_link, "tool_frame");
  EXPECT_EQ(semantics.end_effectors[0].parent_group, "arm");
  EXPECT_FALSE(semantics.virtual_joint) << "the robot has a link for the world";
  ASSERT_EQ(semantics.states.size(), 2U);
  EXPECT_EQ(semantics.states[0].positions,
            (std::vector<std::pair<std::string, double>>{{"j1", 0}, {"j2", 0}, {"j3", 1.5}}));
  EXPECT_EQ(semantics.states[1].positions,
            (std::vector<std::pair<std::string, double>>{{"f1", 0}}));
}

TEST(Semantics, OfAnArmEndWithTheLongestLineOfFrames) {
  const author::Semantics semantics =
      author::semantics_of(robot_from(drawn({{"j1", "revolute", "base", "l1"},
                                             {"j2", "revolute", "l1", "l2"},
                                             {"s", "fixed", "l2", "sensor_frame"},
                                             {"t", "fixed", "l2", "flange_frame"},
                                             {"u", "fixed", "flange_frame", "tool_frame"}})));
  EXPECT_EQ(group_lines(semantics), Lines{"arm: base..tool_frame"});
  ASSERT_TRUE(semantics.virtual_joint);
  EXPECT_EQ(semantics.virtual_joint->child_link, "base");
  EXPECT_EQ(semantics.virtual_joint->type, "fixed");
}

TEST(Semantics, OfATorsoWithArmsAreNoGripper) {
  const author::Semantics semantics = author::semantics_of(
      robot_from(drawn({{"t1", "revolute", "base", "waist", "0.1"},
                        {"t2", "revolute", "waist", "chest", "0.1"},
                        {"left_arm_joint_1", "revolute", "chest", "la1", "0.2"},
                        {"left_arm_joint_2", "revolute", "la1", "la2", "0.3"},
                        {"right_arm_joint_1", "revolute", "chest", "ra1", "0.2"},
                        {"right_arm_joint_2", "revolute", "ra1", "ra2", "0.3"}})));
  EXPECT_EQ(group_lines(semantics),
            (Lines{"t: base..chest", "left_arm: chest..la2", "right_arm: chest..ra2"}));
  EXPECT_TRUE(semantics.end_effectors.empty());
}

TEST(Semantics, OfAWheeledBaseHasAPlanarJointAndNoGroups) {
  const author::Semantics semantics = author::semantics_of(robot_from(drawn(
      {{"l", "continuous", "base", "lw", "0", ""}, {"r", "continuous", "base", "rw", "0", ""}})));
  EXPECT_TRUE(semantics.groups.empty());
  ASSERT_TRUE(semantics.virtual_joint);
  EXPECT_EQ(semantics.virtual_joint->type, "planar");
}

TEST(Semantics, OfAGripperAlone) {
  const std::string follow =
      "<limit lower='-1' upper='1' effort='1' velocity='1'/><mimic joint='knuckle'/>";
  const author::Semantics semantics = author::semantics_of(
      robot_from(drawn({{"knuckle", "revolute", "palm", "left"},
                        {"tip", "revolute", "left", "left_tip", "0", follow},
                        {"other", "revolute", "palm", "right", "0", follow}})));
  EXPECT_EQ(group_lines(semantics), Lines{"gripper: left left_tip right"});
  EXPECT_EQ(semantics.states.at(0).positions.size(), 1U);
}

TEST(SrdfText, IsWellFormedWithNamesThatNeedEntities) {
  author::Semantics semantics{.robot = "a<b"};
  semantics.groups.push_back({.name = "x\"y", .base_link = "p&q", .tip_link = "t"});
  semantics.states.push_back({"home", "x\"y", {{"j", -0.0}, {"k", 0.1}}});
  semantics.disabled.push_back({"p&q", "t", "Never"});
  const std::string text = author::srdf_text(semantics);
  const xml::Document document = xml::parse(text, SourceId{0});
  ASSERT_TRUE(document.complete() && document.faults().empty()) << text;
  EXPECT_EQ(document.root()->attribute("name")->value(), "a<b");
  EXPECT_EQ(document.root()->child("group")->child("chain")->attribute("base_link")->value(),
            "p&q");
  EXPECT_NE(text.find("<joint name=\"j\" value=\"0\"/>"), std::string::npos) << text;
  EXPECT_NE(text.find("<joint name=\"k\" value=\"0.1\"/>"), std::string::npos) << text;
}

std::string updated(const std::string& text, const std::vector<author::DisabledPair>& pairs) {
  const xml::Document document = xml::parse(text, SourceId{0});
  const author::MatrixUpdate update = author::updated_matrix(document, pairs);
  EXPECT_EQ(update.refused, "");
  const auto result = apply_edits(text, update.edits);
  EXPECT_TRUE(result);
  return result.value_or("");
}

TEST(SrdfUpdate, KeepsWhatPeopleWrote) {
  const std::string before =
      "<robot name='r'>\n"
      "  <!-- our arm -->\n"
      "  <group name='arm'><chain base_link='a' tip_link='d'/></group>\n"
      "  <disable_collisions link1='b' link2='a' reason='Never'/> <!-- checked by hand -->\n"
      "  <disable_collisions link1='a' link2='c' reason='Never'/>\n"
      "  <disable_collisions link1='a' link2='d' reason='User'/>\n"
      "  <disable_collisions link1='b' link2='d' reason='Adjacent'/>\n"
      "  <passive_joint name='p'/>\n"
      "</robot>\n";
  const std::string after =
      "<robot name='r'>\n"
      "  <!-- our arm -->\n"
      "  <group name='arm'><chain base_link='a' tip_link='d'/></group>\n"
      "  <disable_collisions link1='b' link2='a' reason='Adjacent'/> <!-- checked by hand -->\n"
      "  <disable_collisions link1='a' link2='d' reason='User'/>\n"
      "  <disable_collisions link1='c' link2='d' reason='Adjacent'/>\n"
      "  <passive_joint name='p'/>\n"
      "</robot>\n";
  EXPECT_EQ(updated(before, {{"a", "b", "Adjacent"}, {"a", "d", "Never"}, {"c", "d", "Adjacent"}}),
            after);
  EXPECT_EQ(updated(after, {{"a", "b", "Adjacent"}, {"a", "d", "Never"}, {"c", "d", "Adjacent"}}),
            after);
}

TEST(SrdfUpdate, AddsToAFileWithoutAMatrixAndReplacesAWholeOne) {
  EXPECT_EQ(updated("<robot name='r'>\n\t<group name='g'/>\n</robot>\n", {{"a", "b", "Never"}}),
            "<robot name='r'>\n\t<group name='g'/>\n"
            "\t<disable_collisions link1='a' link2='b' reason='Never'/>\n</robot>\n");
  EXPECT_EQ(updated("<robot name='r'>\n  <disable_collisions link1='x' link2='y' "
                    "reason='Never'/>\n</robot>\n",
                    {{"a", "b", "Never"}}),
            "<robot name='r'>\n  <disable_collisions link1='a' link2='b' "
            "reason='Never'/>\n</robot>\n");
}

TEST(SrdfUpdate, RefusesWhatIsNoSrdf) {
  const std::string text = "<sdf/>";
  const xml::Document document = xml::parse(text, SourceId{0});
  EXPECT_NE(author::updated_matrix(document, {}).refused, "");
}

}  // namespace
}  // namespace rigor::test
