// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/registry.h>

#include <gtest/gtest.h>

#include <rigor/rules/baseline.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>

namespace rigor::rules {
namespace {

TEST(FormerName, LeadsToARuleThatExistsAndIsNoRulesNameNow) {
  const Registry registry;
  for (const std::string_view former : former_names()) {
    const Rule* rule = registry.find(former);
    ASSERT_NE(rule, nullptr) << former;
    EXPECT_NE(rule->name, former);
    EXPECT_EQ(current_name(rule->name), rule->name);
  }
}

TEST(FormerName, OfOtherRulesIsTheirOwn) { EXPECT_EQ(current_name("axis-zero"), "axis-zero"); }

/// A joint of SDF 1.10 with a limit that means none, and a comment before it.
std::size_t findings(const std::string& comment, const Selection& selection) {
  MemoryDisk disk;
  disk.put("a.sdf",
           "<sdf version='1.10'><model name='m'><link name='a'/><link name='b'/>" + comment +
               "<joint name='j' type='revolute'><parent>a</parent><child>b</child><axis><limit>"
               "<lower>-1e16</lower><upper>1e16</upper></limit></axis></joint></model></sdf>");
  const Environment environment(disk, {});
  Sources sources;
  std::size_t found = 0;
  const auto result = validate(environment, {.paths = {"a.sdf"}, .selection = selection}, sources);
  for (const Diagnostic& diagnostic : result.diagnostics.list()) {
    found += diagnostic.rule == "limit-used-as-unlimited";
  }
  return found;
}

TEST(FormerName, IsAcceptedInSelectionsAndComments) {
  EXPECT_EQ(findings("", {}), 1U);
  EXPECT_EQ(findings("", {.select = {"limit-stands-for-none"}}), 1U);
  EXPECT_EQ(findings("", {.ignore = {"limit-stands-for-none"}}), 0U);
  EXPECT_EQ(findings("<!-- rigor: ignore[limit-stands-for-none] -->", {}), 0U);
}

TEST(FormerName, IsAcceptedInBaselines) {
  const BaselineFile file = read_baseline("2 limit-stands-for-none a.sdf\n");
  ASSERT_TRUE(file.problems.empty());
  EXPECT_EQ(file.baseline.begin()->first.rule, "limit-used-as-unlimited");
}

}  // namespace
}  // namespace rigor::rules
