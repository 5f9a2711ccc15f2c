// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/gitlab.h>

#include <set>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <report/found.h>

namespace rigor::report {
namespace {

using GitlabJson = nlohmann::ordered_json;

GitlabJson gitlab_of(const Found& found) { return GitlabJson::parse(gitlab(found.validation())); }

TEST(Gitlab, AnIssueForEachFinding) {
  Found found;
  found.folders = {"/builds/group/repo/robots", "/builds/group/repo"};
  found.file("./arm.sdf", "<a>\n <xyz>0 0 0</xyz>").at("0 0 0", {.message = "the axis is 0 0 0"});
  const GitlabJson all = gitlab_of(found);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0]["description"], "axis-zero: the axis is 0 0 0");
  EXPECT_EQ(all[0]["check_name"], "axis-zero");
  EXPECT_EQ(all[0]["severity"], "major");
  EXPECT_EQ(all[0]["location"]["path"], "robots/arm.sdf");
  EXPECT_EQ(all[0]["location"]["lines"]["begin"], 2);
  EXPECT_FALSE(all[0]["fingerprint"].get<std::string>().empty());
}

TEST(Gitlab, AFindingWithoutATextIsInLineOne) {
  Found found;
  found.file("a.sdf", "x").add({.message = "no triangles", .path = "wheel.stl"});
  EXPECT_EQ(gitlab_of(found)[0]["location"]["path"], "wheel.stl");
  EXPECT_EQ(gitlab_of(found)[0]["location"]["lines"]["begin"], 1);
}

TEST(Gitlab, Severities) {
  Found found;
  found.file("a.sdf", "x")
      .at("x", {.rule = "xml-not-well-formed", .category = "xml"})
      .at("x", {})
      .at("x", {.severity = Severity::kWarning})
      .at("x", {.severity = Severity::kInfo});
  const GitlabJson all = gitlab_of(found);
  EXPECT_EQ(all[0]["severity"], "blocker");
  EXPECT_EQ(all[1]["severity"], "major");
  EXPECT_EQ(all[2]["severity"], "minor");
  EXPECT_EQ(all[3]["severity"], "info");
}

TEST(Gitlab, FingerprintsAreUniqueAndStayWhenLinesMove) {
  const auto with = [](const std::string& above) {
    Found found;
    found.file("a.sdf", above + "x y")
        .at("x", {.message = "it"})
        .at("y", {.message = "it"})
        .at("y", {.message = "something else"});
    std::vector<std::string> prints;
    for (const auto& issue : gitlab_of(found)) prints.push_back(issue["fingerprint"]);
    return prints;
  };
  EXPECT_EQ(with(""), with("\n<!-- new -->\n"));
  const auto prints = with("");
  EXPECT_EQ(std::set<std::string>(prints.begin(), prints.end()).size(), 3U);
}

TEST(Gitlab, ACleanRunIsTheEmptyList) { EXPECT_EQ(gitlab(Found().validation()), "[]\n"); }

}  // namespace
}  // namespace rigor::report
