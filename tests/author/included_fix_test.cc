// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Fixes of files that templates include: what is expected is the file as it was before a fault was planted.

#include <rigor/author/fix.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>

namespace rigor::author {
namespace {

using Files = std::map<std::string, std::string>;

constexpr const char* kXmlns = " xmlns:xacro=\"http://www.ros.org/wiki/xacro\"";

/// A file with a macro of a wheel on a joint about an axis.
std::string wheel_macro(const std::string& axis) {
  return std::string("<robot") + kXmlns +
         ">\n<xacro:macro name=\"wheel\" params=\"side\">\n"
         "  <link name=\"${side}_wheel\"/>\n"
         "  <joint name=\"${side}_axle\" type=\"continuous\">\n"
         "    <parent link=\"base\"/><child link=\"${side}_wheel\"/>\n"
         "    <axis xyz=\"" +
         axis + "\"/>\n  </joint>\n</xacro:macro>\n</robot>\n";
}

/// A robot with a wheel on each of the sides, and what else is given.
std::string wheeled_robot(const std::vector<std::string>& sides, const std::string& more = {}) {
  std::string text =
      std::string("<robot name=\"r\"") + kXmlns +
      ">\n<xacro:include filename=\"../common/wheel.xacro\"/>\n<link name=\"base\"/>\n";
  for (const std::string& side : sides) text += "<xacro:wheel side=\"" + side + "\"/>\n";
  return text + more + "</robot>\n";
}

std::vector<FixedFile> fixes_in(const Files& files, rules::ValidateOptions options,
                                Applicability most = Applicability::kSafe) {
  const MemoryDisk disk(files);
  const Environment environment(disk, {});
  Sources sources;
  const auto result = rules::validate(environment, options, sources);
  return fix_files(environment, options, result, sources, most);
}

TEST(IncludedFix, IsDoneOnceForAllRobots) {
  const Files files{{"a/robot.urdf.xacro", wheeled_robot({"left", "right"})},
                    {"b/robot.urdf.xacro", wheeled_robot({"rear"})},
                    {"common/wheel.xacro", wheel_macro("0 2 0")}};
  const auto fixed = fixes_in(files, {.paths = {"a", "b", "common"}});
  ASSERT_EQ(fixed.size(), 1U);
  EXPECT_EQ(fixed.front().path, "common/wheel.xacro");
  EXPECT_EQ(fixed.front().before, files.at("common/wheel.xacro"));
  EXPECT_EQ(fixed.front().after, wheel_macro("0 1 0"));
  EXPECT_TRUE(fixed.front().settled);
}

TEST(IncludedFix, GoesWithThoseOfTheRobot) {
  const auto own_joint = [](const std::string& axis) {
    return "<link name=\"arm\"/>\n<joint name=\"lift\" type=\"continuous\"><parent link=\"base\"/>"
           "<child link=\"arm\"/><axis xyz=\"" +
           axis + "\"/></joint>\n";
  };
  const Files files{{"a/robot.urdf.xacro", wheeled_robot({"left"}, own_joint("0 0 3"))},
                    {"common/wheel.xacro", wheel_macro("0 2 0")}};
  const auto fixed = fixes_in(files, {.paths = {"a", "common"}});
  ASSERT_EQ(fixed.size(), 2U);
  EXPECT_EQ(fixed[0].after, wheeled_robot({"left"}, own_joint("0 0 1")));
  EXPECT_EQ(fixed[1].after, wheel_macro("0 1 0"));
}

TEST(IncludedFix, IsNotOfferedWhereOnlyTheRobotIsNamed) {
  const Files files{{"a/robot.urdf.xacro", wheeled_robot({"left"})},
                    {"common/wheel.xacro", wheel_macro("0 2 0")}};
  const MemoryDisk disk(files);
  const Environment environment(disk, {});
  Sources sources;
  const auto result = rules::validate(environment, {.paths = {"a"}}, sources);
  std::size_t found = 0;
  for (const Diagnostic& finding : result.diagnostics.list()) {
    if (finding.rule != "axis-not-unit") continue;
    ++found;
    EXPECT_TRUE(finding.fixes.empty());
  }
  EXPECT_EQ(found, 1U);
  EXPECT_TRUE(fixes_in(files, {.paths = {"a"}}).empty());
}

/// A model of one link with what the caller of the macro puts between its two visuals.
std::string plate_model(const std::string& visual) {
  return std::string("<sdf version=\"1.9\"") + kXmlns +
         "><model name=\"m\"><static>true</static>\n"
         "<xacro:include filename=\"plate.xacro\"/>\n<xacro:plate><visual name=\"" +
         visual + "\"/></xacro:plate>\n</model></sdf>\n";
}

std::string plate_macro(const std::string& element) {
  return std::string("<robot") + kXmlns +
         "><xacro:macro name=\"plate\" params=\"*more\">\n<link name=\"plate\">\n"
         "<xacro:insert_block name=\"more\"/>\n<" +
         element + " name=\"top\"/>\n</link>\n</xacro:macro></robot>\n";
}

TEST(IncludedFix, IsHeldBackWhenItHarmsOneOfTheRobots) {
  const rules::Selection selection{.select = {"wrong-case-element", "naming"}};
  Files files{{"good.sdf.xacro", plate_model("bottom")}, {"plate.xacro", plate_macro("Visual")}};
  const auto fixed =
      fixes_in(files, {.paths = {"."}, .selection = selection}, Applicability::kUnsafe);
  ASSERT_EQ(fixed.size(), 1U);
  EXPECT_EQ(fixed.front().after, plate_macro("visual"));
  // Here another visual has the name already, which the misspelled one does not take yet.
  files["taken.sdf.xacro"] = plate_model("top");
  const auto held =
      fixes_in(files, {.paths = {"."}, .selection = selection}, Applicability::kUnsafe);
  ASSERT_EQ(held.size(), 1U);
  EXPECT_FALSE(held.front().changed());
  ASSERT_EQ(held.front().held_back.size(), 1U);
  EXPECT_EQ(held.front().held_back.front().why, HeldBack::kBringsFinding);
}

}  // namespace
}  // namespace rigor::author
