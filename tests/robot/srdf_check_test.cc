// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// SRDF files with one fault each, and which of them are none.

#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/read/load.h>
#include <rigor/read/srdf/robot_name.h>
#include <rigor/robot/semantic/soft_limits.h>
#include <rigor/robot/semantic/srdf_check.h>
#include <rigor/schema/embedded.h>

namespace rigor::test {
namespace {

using robot::SrdfFact;
using robot::SrdfFactKind;

robot::SemanticTarget target_from(const std::string& inside) {
  const auto sdf = std::get<schema::Schema>(schema::Schema::parse(schema::sdf_schema_text()));
  const auto urdf = std::get<schema::Schema>(schema::Schema::parse(schema::urdf_schema_text()));
  const MemoryDisk disk(
      std::map<std::string, std::string>{{"a.urdf", "<robot name='arm'>" + inside + "</robot>"}});
  const read::Resolver resolver(disk, {});
  Sources sources;
  read::Workspace workspace(disk, sources);
  return robot::semantic_target(
      read::load({workspace, resolver, sdf, urdf}, workspace.open("a.urdf")).root);
}

std::string semantic_link(const std::string& name) {
  return "<link name='" + name +
         "'><collision><geometry><sphere radius='1'/></geometry></collision></link>";
}

std::string semantic_joint(const std::string& name, const std::string& parent,
                           const std::string& child, const std::string& more = "") {
  return "<joint name='" + name + "' type='revolute'><parent link='" + parent + "'/><child link='" +
         child + "'/><limit lower='-1' upper='2' effort='1' velocity='1'/>" + more + "</joint>";
}

/// a → b → c and a → d.
const std::string& forked_arm() {
  static const std::string kArm = semantic_link("a") + semantic_link("b") + semantic_link("c") +
                                  semantic_link("d") + semantic_joint("ab", "a", "b") +
                                  semantic_joint("bc", "b", "c") + semantic_joint("ad", "a", "d");
  return kArm;
}

std::vector<SrdfFact> facts_of(const std::string& inside, const robot::SemanticTarget& target) {
  const std::string text = "<robot name='arm'>" + inside + "</robot>";
  const xml::Document document = xml::parse(text, SourceId{0});
  return robot::check_srdf(read::read_srdf(*document.root()), {&target});
}

std::vector<SrdfFactKind> kinds_in(const std::string& inside) {
  std::vector<SrdfFactKind> kinds;
  for (const SrdfFact& fact : facts_of(inside, target_from(forked_arm())))
    kinds.push_back(fact.kind);
  return kinds;
}

using Kinds = std::vector<SrdfFactKind>;

TEST(SrdfCheck, FindsNamesThatDoNotExist) {
  EXPECT_EQ(kinds_in("<group name='g'><link name='x'/><joint name='y'/><group name='h'/></group>"),
            (Kinds{SrdfFactKind::kLinkUndefined, SrdfFactKind::kJointUndefined,
                   SrdfFactKind::kGroupUndefined}));
  EXPECT_EQ(kinds_in("<virtual_joint name='v' type='fixed' parent_frame='any' child_link='a'/>"
                     "<group name='g'><joint name='v'/><link name='d'/></group>"
                     "<end_effector name='e' parent_link='c' group='g'/>"),
            Kinds{});
  EXPECT_EQ(kinds_in("<disable_collisions link1='a' link2='x'/><disable_collisions link1='a' "
                     "link2='b'/><disable_collisions link1='b' link2='c'/><disable_collisions "
                     "link1='d' link2='a'/>"),
            Kinds{SrdfFactKind::kLinkUndefined});
}

TEST(SrdfCheck, FindsChainsThatAreNone) {
  const auto chain = [](const std::string& base, const std::string& tip) {
    return kinds_in("<group name='g'><chain base_link='" + base + "' tip_link='" + tip +
                    "'/></group>");
  };
  EXPECT_EQ(chain("a", "c"), Kinds{});
  EXPECT_EQ(chain("b", "c"), Kinds{});
  EXPECT_EQ(chain("c", "a"), Kinds{SrdfFactKind::kChainBroken});
  EXPECT_EQ(chain("d", "c"), Kinds{SrdfFactKind::kChainBroken});
  EXPECT_EQ(chain("b", "b"), Kinds{SrdfFactKind::kChainEmpty});
  EXPECT_EQ(chain("a", "x"), Kinds{SrdfFactKind::kLinkUndefined}) << "one fault, one finding";
}

TEST(SrdfCheck, FindsStatesOutsideTheLimits) {
  const auto state = [](const std::string& value) {
    return kinds_in(
        "<group name='g'><joint name='ab'/></group><group_state name='s' group='g'>"
        "<joint name='ab' value='" +
        value + "'/></group_state>");
  };
  EXPECT_EQ(state("2"), Kinds{});
  EXPECT_EQ(state("-1.00005"), Kinds{}) << "few digits are no fault";
  EXPECT_EQ(state("2.1"), Kinds{SrdfFactKind::kStateOutside});
  EXPECT_EQ(state("1 2 3"), Kinds{}) << "of a joint with several axes";
  EXPECT_EQ(state("nan"), Kinds{});
}

TEST(SrdfCheck, TakesSoftLimitsWhereTheyAreNarrower) {
  const auto upper = [](const std::string& soft) {
    return target_from(semantic_link("a") + semantic_link("b") +
                       semantic_joint("ab", "a", "b", "<safety_controller " + soft + "/>"))
        .joints.at("ab")
        .upper;
  };
  EXPECT_EQ(upper("soft_lower_limit='-0.5' soft_upper_limit='0.5' k_velocity='1'"), 0.5);
  EXPECT_EQ(upper("soft_lower_limit='-5' soft_upper_limit='5' k_velocity='1'"), 2);
  EXPECT_EQ(upper("k_velocity='1'"), 2) << "0 to 0 is what is not written";
  EXPECT_EQ(upper("soft_lower_limit='1' soft_upper_limit='-1' k_velocity='1'"), 2);
}

TEST(SrdfCheck, FindsNeighborsThatAMatrixLacks) {
  const auto pair = [](const std::string& a, const std::string& b) {
    return "<disable_collisions link1='" + a + "' link2='" + b + "' reason='Adjacent'/>";
  };
  EXPECT_EQ(kinds_in(pair("b", "a") + pair("b", "c") + pair("a", "d")), Kinds{});
  EXPECT_EQ(kinds_in(""), Kinds{}) << "there is no matrix";
  const auto facts = facts_of(pair("a", "b"), target_from(forked_arm()));
  ASSERT_EQ(facts.size(), 1U);
  EXPECT_EQ(facts[0].kind, SrdfFactKind::kPairsChecked);
  EXPECT_EQ(facts[0].count, 2U);
  EXPECT_EQ(facts[0].name + facts[0].other, "bc");
  EXPECT_EQ(kinds_in(pair("a", "b") + pair("b", "c") + "<disable_default_collisions link='d'/>"),
            Kinds{});
}

TEST(SrdfCheck, IsContentWithOneOfSeveralRobots) {
  const robot::SemanticTarget arm = target_from(forked_arm());
  const robot::SemanticTarget other = target_from(semantic_link("x"));
  const std::string text =
      "<robot name='arm'><group name='g'><link name='x'/><link name='c'/>"
      "<link name='y'/></group></robot>";
  const xml::Document document = xml::parse(text, SourceId{0});
  const auto facts = robot::check_srdf(read::read_srdf(*document.root()), {&arm, &other});
  ASSERT_EQ(facts.size(), 1U);
  EXPECT_EQ(facts[0].name, "y");
}

TEST(RobotName, IsThatOfTheFirstTag) {
  EXPECT_EQ(read::robot_name_in("<?xml version='1.0'?>\n<robot name='arm' xmlns:x='y'>"), "arm");
  EXPECT_EQ(read::robot_name_in("<robot name='${name}'>"), "");
  EXPECT_EQ(read::robot_name_in("<sdf/>"), "");
}

}  // namespace
}  // namespace rigor::test
