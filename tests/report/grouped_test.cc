// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The places of one cause, in each format.

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <rigor/report/github.h>
#include <rigor/report/gitlab.h>
#include <rigor/report/json/json.h>
#include <rigor/report/jsonl.h>
#include <rigor/report/junit/junit.h>
#include <rigor/report/sarif/sarif.h>
#include <rigor/report/terminal/concise.h>
#include <rigor/report/terminal/pretty.h>
#include <rigor/report/terminal/shown.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/text/grouping.h>

#include <report/found.h>

namespace rigor::report {
namespace {

using PlacesJson = nlohmann::json;

/// One cause at two places of arm.sdf and at one of leg.sdf, and an info.
class OneCause : public testing::Test {
 protected:
  OneCause() {
    found_.file("arm.sdf", "aa\nbb\ncc\n")
        .at("aa", {.message = "'a' is not found", .subject = "arm/link a", .cause = "package p"})
        .at("cc", {.message = "'c' is not found", .subject = "arm/link c", .cause = "package p"})
        .at("bb", {.severity = Severity::kInfo, .message = "by the way"});
    found_.file("leg.sdf", "dd\n")
        .at("dd", {.message = "'d' is not found", .subject = "leg/link d", .cause = "package p"});
  }

  Diagnostics groups() const { return grouped(found_.result.diagnostics); }

  Found found_;
};

TEST_F(OneCause, Json) {
  const auto document = PlacesJson::parse(json(found_.result, found_.sources));
  EXPECT_EQ(document["summary"]["errors"], 1);
  EXPECT_EQ(document["summary"]["infos"], 1);
  EXPECT_EQ(document["summary"]["places"], 4);
  const auto& first = document["diagnostics"][0];
  EXPECT_EQ(first["line"], 1);
  EXPECT_EQ(first["docs"], "rules/axis-zero.md");
  ASSERT_EQ(first["places"].size(), 2U);
  EXPECT_EQ(first["places"][0]["line"], 3);
  EXPECT_EQ(first["places"][0]["message"], "'c' is not found");
  EXPECT_EQ(first["places"][1]["path"], "leg.sdf");
  EXPECT_EQ(first["places"][1]["subject"], "leg/link d");
  EXPECT_TRUE(document["diagnostics"][1]["places"].empty());
}

TEST_F(OneCause, JsonOfWhyAndHelpAndOrigin) {
  Found found;
  found.file("arm.sdf", "aa\nbb\n");
  Diagnostic finding;
  finding.message = "m";
  finding.page_why = "The page.";
  finding.help = "Write another.";
  finding.page_help = "The page's help.";
  finding.origin.push_back({"leg", found.span_of("bb"), {{"prefix", "FL"}}});
  found.at("aa", finding);
  const auto one = PlacesJson::parse(json(found.result, found.sources))["diagnostics"][0];
  EXPECT_EQ(one["why"], "The page.");
  EXPECT_EQ(one["help"], "Write another.");
  const PlacesJson call = {{"macro", "leg"},
                           {"path", "arm.sdf"},
                           {"line", 2},
                           {"column", 1},
                           {"params", {{"prefix", "FL"}}}};
  EXPECT_EQ(one["origin"], PlacesJson::array({call}));
  const std::string text = pretty(found.result.diagnostics, found.sources, Color::kPlain);
  EXPECT_NE(text.find("= in macro 'leg' (prefix='FL'), called at arm.sdf:2\n"), text.npos) << text;
}

TEST_F(OneCause, JsonLinesOfEachFile) {
  const std::string text = jsonl(found_.validation());
  const auto arm = PlacesJson::parse(text.substr(0, text.find('\n')));
  ASSERT_EQ(arm["diagnostics"].size(), 2U);
  EXPECT_EQ(arm["diagnostics"][0]["places"].size(), 1U);
  const auto leg = PlacesJson::parse(text.substr(text.find('\n')));
  ASSERT_EQ(leg["diagnostics"].size(), 1U);
  EXPECT_TRUE(leg["diagnostics"][0]["places"].empty());
}

TEST_F(OneCause, Sarif) {
  const auto results = PlacesJson::parse(sarif(found_.validation()))["runs"][0]["results"];
  ASSERT_EQ(results.size(), 2U);
  ASSERT_EQ(results[0]["locations"].size(), 3U);
  EXPECT_EQ(results[0]["message"]["text"], "'a' is not found. And 2 more places.");
  const auto& last = results[0]["locations"][2];
  EXPECT_EQ(last["physicalLocation"]["artifactLocation"]["uri"], "leg.sdf");
  EXPECT_EQ(last["logicalLocations"][0]["fullyQualifiedName"], "leg/link d");
}

TEST_F(OneCause, GithubHasOneAnnotation) {
  const std::string text = github(found_.validation());
  EXPECT_EQ(text.find("::error"), text.rfind("::error"));
  EXPECT_NE(text.find("%0Aand 2 more in 2 files: line 3, leg.sdf:1"), text.npos) << text;
}

TEST_F(OneCause, GitlabHasOneIssueAPlace) {
  EXPECT_EQ(PlacesJson::parse(gitlab(found_.validation())).size(), 4U);
}

TEST_F(OneCause, JunitHasOneCaseAFile) {
  const std::string text = junit(found_.validation());
  EXPECT_NE(text.find("<testsuites name=\"rigor\" tests=\"3\" failures=\"2\""), text.npos) << text;
  EXPECT_NE(text.find("&#39; is not found (and 1 more: line 3) [axis-zero]"), text.npos) << text;
}

TEST_F(OneCause, Terminal) {
  EXPECT_EQ(concise(groups(), found_.sources),
            "arm.sdf:1:1: error: 'a' is not found (and 2 more in 2 files: line 3, leg.sdf:1) "
            "[axis-zero]\n"
            "arm.sdf:2:1: info: by the way [axis-zero]\n");
  const std::string text = pretty(groups(), found_.sources, Color::kPlain);
  EXPECT_NE(text.find("  = and 2 more in 2 files: line 3, leg.sdf:1\n"), text.npos) << text;
  EXPECT_EQ(summary(grouped(found_.result, GroupScope::kRun)),
            "2 files checked: 1 error, 1 info at 4 places");
}

TEST_F(OneCause, WhatIsNotShownIsCounted) {
  EXPECT_EQ(shown(groups(), Severity::kWarning).list().size(), 1U);
  EXPECT_EQ(not_shown(groups(), Severity::kWarning), "1 note in 1 rule; --show info");
  EXPECT_EQ(not_shown(groups(), Severity::kInfo), "");
}

TEST_F(OneCause, TableOfRules) {
  EXPECT_EQ(rule_table(groups(), found_.sources),
            "severity rule      findings   places  first place\n"
            "error    axis-zero        1        3  arm.sdf:1:1\n"
            "info     axis-zero        1        1  arm.sdf:2:1\n");
}

TEST(ManyPlaces, AreFolded) {
  Found found;
  found.file("arm.sdf", "0\n1\n2\n3\n4\n5\n6\n7\n8\n9\n");
  for (const char* line : {"0", "1", "2", "3", "4", "5", "6", "7", "8", "9"}) {
    found.at(line, {.message = "m"});
  }
  EXPECT_EQ(concise(grouped(found.result.diagnostics), found.sources),
            "arm.sdf:1:1: error: m (and 9 more: lines 2, 3, 4, 5, 6, 7, 8, 9, …) [axis-zero]\n");
}

TEST(Junit, AFindingBelowTheThresholdPasses) {
  Found found;
  found.file("arm.sdf", "a\nb\n")
      .at("a", {.severity = Severity::kWarning, .message = "m"})
      .at("b", {.message = "n"});
  const auto report = [&found](Severity least) {
    Validation validation = found.validation();
    validation.fail_on = [least](const std::string& /*path*/) { return least; };
    return junit(validation);
  };
  EXPECT_NE(report(Severity::kError).find("failures=\"1\""), std::string::npos);
  EXPECT_NE(report(Severity::kWarning).find("failures=\"2\""), std::string::npos);
}

}  // namespace
}  // namespace rigor::report
