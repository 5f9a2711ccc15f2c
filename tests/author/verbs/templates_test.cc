// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Verbs on xacro: changes are written where their author wrote, or refused, and the proof finds what a macro changes too.

#include <gtest/gtest.h>

#include <rigor/author/verbs/add/add.h>
#include <rigor/author/verbs/prefix.h>
#include <rigor/author/verbs/remove.h>
#include <rigor/author/verbs/set_value.h>

#include "author/verbs/verb_bench.h"

namespace rigor::author {
namespace {

std::string two_armed(const std::string& arms) {
  return R"(<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="reach" value="0.5"/>
  <link name="base"/>
  <xacro:macro name="arm" params="side">
    <joint name="${side}_joint" type="revolute">
      <origin xyz="0 0 ${reach}"/>
      <parent link="base"/> <child link="${side}_arm"/>
      <axis xyz="0 0 1"/>
      <limit lower="-1" upper="1" effort="1" velocity="1"/>
    </joint>
    <link name="${side}_arm"/>
  </xacro:macro>
)" + arms +
         R"(  <link name="flag"/>
  <joint name="mast" type="fixed">
    <parent link="base"/> <child link="flag"/>
  </joint>
</robot>
)";
}

TEST(TemplateVerbs, ANumberWhereItIsWritten) {
  const std::string one = two_armed("  <xacro:arm side=\"left\"/>\n");
  VerbBench bench({{"r.urdf.xacro", one}});
  const EditedModel& robot = bench.open("r.urdf.xacro");
  std::string expected = one;
  expected.replace(expected.find("upper=\"1\""), 9, "upper=\"2\"");
  EXPECT_EQ(bench.text(robot, with_limits(robot, "left_joint", {.upper = 2})), expected);
}

TEST(TemplateVerbs, AMacroThatIsCalledTwiceChangesMoreThanWasAsked) {
  VerbBench bench({{"r.urdf.xacro",
                    two_armed("  <xacro:arm side=\"left\"/>\n  <xacro:arm side=\"right\"/>\n")}});
  const EditedModel& robot = bench.open("r.urdf.xacro");
  const ProvenChange proven = bench.prove(robot, with_limits(robot, "left_joint", {.upper = 2}));
  EXPECT_EQ(proven.refused, "");
  EXPECT_FALSE(proven.holds());
  ASSERT_EQ(proven.unasked.size(), 1U);
  EXPECT_EQ(proven.unasked[0].kind, robot::DifferenceKind::kUpper);
  EXPECT_EQ(proven.unasked[0].a, "joint right_joint");
}

TEST(TemplateVerbs, WhatAnExpressionComputesIsRefused) {
  VerbBench bench({{"r.urdf.xacro", two_armed("  <xacro:arm side=\"left\"/>\n")}});
  const EditedModel& robot = bench.open("r.urdf.xacro");
  EXPECT_EQ(bench.prove(robot, with_pose(robot, "left_joint", {{0, 0, 1}, {}})).refused,
            "r.urdf.xacro:6 is computed by an expression");
}

TEST(TemplateVerbs, TheLiteralBesideAnExpressionTakesAPrefix) {
  const std::string both =
      two_armed("  <xacro:arm side=\"left\"/>\n  <xacro:arm side=\"right\"/>\n");
  VerbBench bench({{"r.urdf.xacro", both}});
  const EditedModel& robot = bench.open("r.urdf.xacro");
  const std::string text = bench.text(robot, prefixed(robot, "p_", {}));
  EXPECT_NE(text.find("name=\"p_${side}_"), std::string::npos) << text;
  EXPECT_EQ(text.find("name=\"${side}_"), std::string::npos) << text;
  const EditedModel& changed = bench.open_text("r.urdf.xacro", text);
  EXPECT_EQ(bench.text(changed, unprefixed(changed, "p_", {})), both);
}

TEST(TemplateVerbs, ANameOfOneCallOfTwoIsRefused) {
  const Change change = [] {
    VerbBench bench({{"r.urdf.xacro",
                      two_armed("  <xacro:arm side=\"left\"/>\n  <xacro:arm side=\"right\"/>\n")}});
    const EditedModel& robot = bench.open("r.urdf.xacro");
    return unprefixed(robot, "left_", {});
  }();
  EXPECT_EQ(change.refused, "an expression composes the name at r.urdf.xacro:5");
}

TEST(TemplateVerbs, ElementsOfTheTemplateItself) {
  const std::string one = two_armed("  <xacro:arm side=\"left\"/>\n");
  VerbBench bench({{"r.urdf.xacro", one}});
  const EditedModel& robot = bench.open("r.urdf.xacro");
  EXPECT_EQ(bench.text(robot, removed(robot, "flag", Subtree::kRefused, {})),
            one.substr(0, one.find("  <link name=\"flag\"")) + "</robot>\n");
}

/// Whichever file the macro is in.
TEST(TemplateVerbs, BehindACallThatIsTheLastOfItsFile) {
  const std::string macro = R"(  <xacro:macro name="wheel" params="n">
    <link name="${n}_wheel"/>
    <joint name="${n}_j" type="fixed"><parent link="base"/><child link="${n}_wheel"/></joint>
  </xacro:macro>
)";
  const std::string begin = "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n";
  const std::string end = "  <link name=\"base\"/>\n  <xacro:wheel n=\"l\"/>\n";
  VerbBench bench(
      {{"one.xacro", begin + macro + end + "</robot>\n"},
       {"two.xacro", begin + "  <xacro:include filename=\"wheel.xacro\"/>\n" + end + "</robot>\n"},
       {"wheel.xacro", begin + macro + "</robot>\n"}});
  for (const std::string file : {"one.xacro", "two.xacro"}) {
    const EditedModel& robot = bench.open(file);
    AddRequest request;
    request.what = "imu";
    request.to = "base";
    const std::string text = bench.text(robot, added(robot, request));
    EXPECT_NE(text.find(end + "  <gazebo reference=\"base\">\n    <sensor "), std::string::npos)
        << text;
    EXPECT_TRUE(text.ends_with("  </gazebo>\n</robot>\n")) << text;
  }
}

}  // namespace
}  // namespace rigor::author
