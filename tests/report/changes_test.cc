// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/changes.h>

#include <gtest/gtest.h>

namespace rigor::report {
namespace {

KnownFinding known_finding(const std::string& subject, const std::string& line = "") {
  return {"a.sdf", "axis-zero", Severity::kError, subject, "the axis is zero", line};
}

TEST(Changes, ComeFromWhatIsSaidNotFromWhere) {
  const std::vector<KnownFinding> before{known_finding("a", "a.sdf:1:1"), known_finding("b")};
  const std::vector<KnownFinding> after{known_finding("a", "a.sdf:7:1"), known_finding("c")};
  const FindingChanges changes = what_changed(before, after);
  EXPECT_EQ(changes.fresh, std::vector<std::size_t>{1});
  EXPECT_EQ(changes.fixed, std::vector<std::size_t>{1});
  EXPECT_EQ(changes.same, 1U);
}

TEST(Changes, OfSeveralAlikeTheLastOnesComeAndGo) {
  const KnownFinding one = known_finding("a");
  const FindingChanges fewer = what_changed({one, one, one}, {one});
  EXPECT_EQ(fewer.same, 1U);
  EXPECT_EQ(fewer.fixed, (std::vector<std::size_t>{1, 2}));
  const FindingChanges more = what_changed({one}, {one, one, one});
  EXPECT_EQ(more.same, 1U);
  EXPECT_EQ(more.fresh, (std::vector<std::size_t>{1, 2}));
}

// Whatever the lists, each finding is accounted for, and the way back is the mirror image.
TEST(Changes, BalanceAndMirror) {
  for (unsigned mask = 0; mask < 4096; ++mask) {
    std::vector<KnownFinding> before;
    std::vector<KnownFinding> after;
    for (unsigned bit = 0; bit < 12; ++bit) {
      if ((mask >> bit & 1U) == 0) continue;
      (bit < 6 ? before : after).push_back(known_finding(std::string(1, "aabbbc"[bit % 6])));
    }
    const FindingChanges there = what_changed(before, after);
    const FindingChanges back = what_changed(after, before);
    ASSERT_EQ(there.same + there.fresh.size(), after.size()) << mask;
    ASSERT_EQ(there.same + there.fixed.size(), before.size()) << mask;
    ASSERT_EQ(there.same, back.same) << mask;
    ASSERT_EQ(there.fresh, back.fixed) << mask;
  }
}

// What is not read cannot be mended.
TEST(Changes, WhatCannotBeReadHidesAndFixesNothing) {
  const KnownFinding axis = known_finding("a");
  KnownFinding elsewhere = known_finding("b");
  elsewhere.path = "b.sdf";
  KnownFinding broken = known_finding("");
  broken.rule = "xml-not-well-formed";

  const FindingChanges breaking = what_changed({axis, elsewhere}, {broken});
  EXPECT_EQ(breaking.fresh, std::vector<std::size_t>{0});
  EXPECT_EQ(breaking.hidden, std::vector<std::size_t>{0});
  EXPECT_EQ(breaking.fixed, std::vector<std::size_t>{1});

  const std::vector<KnownFinding> kept = remembered({axis, elsewhere}, {broken});
  ASSERT_EQ(kept.size(), 2U);
  const FindingChanges still_broken = what_changed(kept, {broken});
  EXPECT_EQ(still_broken.same, 1U);
  EXPECT_EQ(still_broken.hidden, std::vector<std::size_t>{1});
  const FindingChanges mended = what_changed(kept, {axis});
  EXPECT_EQ(mended.same, 1U);
  EXPECT_EQ(mended.fixed, std::vector<std::size_t>{0});
  EXPECT_TRUE(mended.fresh.empty());
}

TEST(Changes, AreTold) {
  Sources sources;
  const SourceId source = sources.add("a.sdf", "<axis/>\n");
  Diagnostics before;
  before.add({.rule = "axis-zero", .message = "the axis is zero", .where = {source, 0, 7}});
  Diagnostics after;
  after.add({.rule = "axis-long", .message = "the axis is long", .where = {source, 0, 7}});
  const std::vector<KnownFinding> known = known_findings(before, sources);

  const std::string both = changes(known, after, sources, Color::kPlain);
  EXPECT_EQ(both.find("error[axis-long]: the axis is long"), 0U) << both;
  EXPECT_NE(both.find("\nfixed: a.sdf:1:1: error: the axis is zero [axis-zero]\n"),
            std::string::npos);
  EXPECT_TRUE(both.ends_with("\n1 new, 1 fixed, 0 findings as before\n")) << both;
  EXPECT_EQ(changes(known, before, sources, Color::kPlain),
            "nothing changed, 1 finding as before\n");
  EXPECT_TRUE(changes(known, {}, sources, Color::kPlain).ends_with("\n1 fixed, no problems\n"));
  EXPECT_EQ(changes({}, {}, sources, Color::kPlain), "nothing changed, no problems\n");
}

}  // namespace
}  // namespace rigor::report
