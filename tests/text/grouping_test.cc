// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/grouping.h>

#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace rigor {
namespace {

/// A finding in the source of that number.
Diagnostic finding_in(std::uint32_t source, std::string message, std::string subject = {},
                      std::string cause = {}) {
  Diagnostic finding;
  finding.rule = "inertial-missing";
  finding.message = std::move(message);
  finding.subject = std::move(subject);
  finding.cause = std::move(cause);
  finding.where = {SourceId{source}, 0, 1};
  return finding;
}

using Sizes = std::vector<std::size_t>;

/// Places of each group.
Sizes group_sizes(std::vector<Diagnostic> findings) {
  Diagnostics list;
  for (Diagnostic& finding : findings) list.add(std::move(finding));
  Sizes sizes;
  const Diagnostics groups = grouped(list);
  for (const Diagnostic& group : groups.list()) sizes.push_back(1 + group.others.size());
  return sizes;
}

TEST(Grouping, OneCauseIsOneFindingInAllFiles) {
  EXPECT_EQ(group_sizes({finding_in(0, "a.stl", {}, "package://arm"),
                         finding_in(0, "b.stl", {}, "package://arm"),
                         finding_in(0, "c.stl", {}, "package://leg"),
                         finding_in(1, "d.stl", {}, "package://arm")}),
            (Sizes{3, 1}));
}

TEST(Grouping, WithoutACauseTheMessageSaysIt) {
  EXPECT_EQ(
      group_sizes({finding_in(0, "no name"), finding_in(1, "no name"), finding_in(1, "another")}),
      (Sizes{2, 1}));
}

TEST(Grouping, MessagesMayDifferInTheNamesOfTheirSubjectsInOneFile) {
  EXPECT_EQ(group_sizes({finding_in(0, "the link 'a' has no mass", "arm/link a"),
                         finding_in(0, "the link 'b' has no mass", "arm/link b"),
                         finding_in(1, "the link 'c' has no mass", "arm/link c")}),
            (Sizes{2, 1}));
  EXPECT_EQ(group_sizes({finding_in(0, "'x' is no number", "arm/link a"),
                         finding_in(0, "'y' is no number", "arm/link b")}),
            (Sizes{1, 1}));
}

TEST(Grouping, RuleAndSeverityAndHelpAreTheSame) {
  Diagnostic info = finding_in(0, "m");
  info.severity = Severity::kInfo;
  Diagnostic other = finding_in(0, "m");
  other.rule = "mass-zero";
  Diagnostic helped = finding_in(0, "m");
  helped.help = "did you mean 'n'?";
  EXPECT_EQ(group_sizes({finding_in(0, "m"), info, other, helped}), (Sizes{1, 1, 1, 1}));
}

TEST(Grouping, WhatStandsForManyStaysAlone) {
  Diagnostic many = finding_in(0, "m");
  many.count = 40;
  EXPECT_EQ(group_sizes({finding_in(0, "m"), many, finding_in(0, "m")}), (Sizes{2, 1}));
}

TEST(Grouping, KeepsEachPlaceInTheOrderOfTheList) {
  Diagnostics list;
  for (const char* subject : {"arm/link a", "arm/link b", "arm/link c"}) {
    list.add(finding_in(0, "m", subject));
  }
  const Diagnostics groups = grouped(list);
  ASSERT_EQ(groups.list().size(), 1U);
  EXPECT_EQ(groups.list()[0].subject, "arm/link a");
  EXPECT_EQ(groups.list()[0].others[1].subject, "arm/link c");
  EXPECT_EQ(groups.places(), 3U);
  EXPECT_EQ(groups.count(Severity::kError), 1U);
  EXPECT_EQ(grouped(groups).list()[0].others.size(), 2U) << "twice is once";
  EXPECT_EQ(ungrouped(groups).list()[1].subject, "arm/link b");
}

TEST(Grouping, TakesOutTheNamesOfTheSubjectOnly) {
  EXPECT_EQ(without_names("'palm' of 'hand' holds 'tip'", "arm::hand/link palm"),
            "'…' of '…' holds 'tip'");
  EXPECT_EQ(without_names("the name 'rr::shank' is reserved", "rover/link rr::shank"),
            "the name '…' is reserved");
  EXPECT_EQ(without_names("it's 'a'", "arm/link a"), "it's '…'");
  EXPECT_EQ(without_names("'a", "arm/link a"), "'a");
}

/// Counting makes no groups, and says what the groups would.
TEST(Grouping, CountsAreThoseOfTheGroups) {
  Diagnostics list;
  const Severity severities[] = {Severity::kError, Severity::kWarning, Severity::kInfo};
  for (std::uint32_t i = 0; i < 60; ++i) {
    Diagnostic finding =
        finding_in(i % 7, i % 3 == 0 ? "no name" : "message " + std::to_string(i % 11));
    finding.severity = severities[i % 3];
    if (i % 13 == 0) finding.count = 4;
    list.add(std::move(finding));
  }
  const Diagnostics groups = grouped(list);
  for (const Diagnostics* each : std::initializer_list<const Diagnostics*>{&list, &groups}) {
    const GroupCounts counts = count_groups(*each);
    for (const Severity severity : severities) {
      EXPECT_EQ(counts.by_severity[static_cast<std::size_t>(severity)], groups.count(severity));
    }
    EXPECT_EQ(counts.places, groups.places());
    EXPECT_TRUE(counts.joined);
  }
  EXPECT_FALSE(count_groups({}).joined);
}

}  // namespace
}  // namespace rigor
