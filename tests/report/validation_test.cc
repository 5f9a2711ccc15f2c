// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/validation.h>

#include <string>

#include <gtest/gtest.h>

#include <report/found.h>

namespace rigor::report {
namespace {

std::string seen_from(const ProjectFolders& folders, const std::string& path) {
  Found found;
  found.folders = folders;
  return project_path(found.validation(), path);
}

TEST(ProjectPath, BeginsAtTheTopOfTheProject) {
  const ProjectFolders inside{"/ci/repo/robots", "/ci/repo"};
  EXPECT_EQ(seen_from(inside, "arm.sdf"), "robots/arm.sdf");
  EXPECT_EQ(seen_from(inside, "./arm/../hand.sdf"), "robots/hand.sdf");
  EXPECT_EQ(seen_from(inside, "../worlds/lab.world"), "worlds/lab.world");
  EXPECT_EQ(seen_from(inside, "/ci/repo/a/b.sdf"), "a/b.sdf");
  EXPECT_EQ(seen_from(inside, "/opt/arm.sdf"), "../../opt/arm.sdf");
  EXPECT_EQ(seen_from({"/ci/repo", "/ci/repo"}, "arm.sdf"), "arm.sdf");
}

TEST(ProjectPath, IsAsGivenWhenNobodySaysWhereItBegins) {
  EXPECT_EQ(seen_from({}, "./robots//arm.sdf"), "robots/arm.sdf");
  EXPECT_EQ(seen_from({}, "/opt/arm.sdf"), "/opt/arm.sdf");
}

TEST(KeepsFromReading, OnlyWhatDoes) {
  EXPECT_TRUE(keeps_from_reading({.rule = "xml-not-well-formed", .category = "xml"}));
  EXPECT_TRUE(keeps_from_reading({.rule = "file-unreadable", .category = "schema"}));
  EXPECT_FALSE(keeps_from_reading({.rule = "axis-zero", .category = "kinematics"}));
  EXPECT_FALSE(keeps_from_reading(
      {.rule = "xml-not-utf8", .category = "xml", .severity = Severity::kWarning}));
}

TEST(KeepsFromReading, NamesRulesThatAre) {
  const rules::Registry registry;
  for (const char* name : {"file-unreadable", "file-too-large", "xml-not-well-formed"}) {
    EXPECT_NE(registry.find(name), nullptr) << name;
  }
}

}  // namespace
}  // namespace rigor::report
