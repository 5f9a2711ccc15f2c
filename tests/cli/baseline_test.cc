// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <gtest/gtest.h>

#include "cli/program.h"

namespace rigor::test {
namespace {

/// A model with so many elements that no format knows.
std::string known_by_none(int count, const std::string& also = "") {
  std::string text = "<sdf version='1.9'><model name='m'><static>1</static><link name='l'/>\n";
  for (int i = 0; i < count; ++i) text += "<zz/>\n";
  return text + also + "</model></sdf>\n";
}

const std::string kStrictly = "validate --fail-on warning ";

std::string baseline_entries(const Folder& folder, const std::string& file = "rigor.baseline") {
  const std::string text = folder.get(file);
  return text.substr(text.find('\n') + 1);
}

TEST(CliBaseline, HidesWhatWasFoundUntilThereIsMore) {
  const Folder folder;
  folder.put("models/a b.sdf", known_by_none(2));
  EXPECT_EQ(folder.rigor(kStrictly).exit, 1);
  const Ran written = folder.rigor(kStrictly + "--baseline-write rigor.baseline");
  EXPECT_EQ(written.exit, 0) << written.err;
  EXPECT_NE(written.err.find("added 2 unknown-element models/a b.sdf"), std::string::npos)
      << written.err;
  EXPECT_EQ(baseline_entries(folder), "2 unknown-element models/a\\sb.sdf\n");

  EXPECT_EQ(folder.rigor(kStrictly + "--baseline rigor.baseline").exit, 0);
  // Seen from elsewhere, and named otherwise, it is the same file.
  EXPECT_EQ(
      folder.rigor(kStrictly + "'" + folder.path("models") + "' --baseline rigor.baseline").exit,
      0);

  folder.put("models/a b.sdf", known_by_none(3));
  const Ran more = folder.rigor(kStrictly + "--format concise --baseline rigor.baseline");
  EXPECT_EQ(more.exit, 1);
  EXPECT_NE(more.out.find("(and 2 more: lines 3, 4) [unknown-element]"), std::string::npos)
      << more.out;
}

TEST(CliBaseline, InAFolderThatIsGone) {
  const Folder folder;
  folder.put("a.sdf", known_by_none(1));
  const std::string gone = "mkdir gone && cd gone && rmdir ../gone &&";
  const std::string file = "'" + folder.path("a.sdf") + "' ";
  const std::string baseline = "'" + folder.path("rigor.baseline") + "'";
  const Ran written = folder.rigor(kStrictly + file + "--baseline-write " + baseline, gone);
  EXPECT_EQ(written.exit, 0) << written.err;
  EXPECT_EQ(baseline_entries(folder), "1 unknown-element a.sdf\n");
}

TEST(CliBaseline, SaysWhatIsStaleAndIsPruned) {
  const Folder folder;
  folder.put("a.sdf", known_by_none(3));
  folder.put("b.sdf", known_by_none(1));
  folder.rigor("validate --baseline-write rigor.baseline");
  folder.put("a.sdf", known_by_none(1));
  const Ran stale = folder.rigor(kStrictly + "--baseline rigor.baseline");
  EXPECT_EQ(stale.exit, 0);
  EXPECT_NE(stale.err.find("--baseline-prune"), std::string::npos) << stale.err;
  EXPECT_EQ(folder.rigor("validate --baseline rigor.baseline --baseline-strict").exit, 1);
  // A run that does not look at the file says nothing of it.
  EXPECT_EQ(folder.rigor("validate b.sdf --baseline rigor.baseline --baseline-strict").exit, 0);
  EXPECT_EQ(
      folder.rigor("validate --ignore schema --baseline rigor.baseline --baseline-strict").exit, 0);

  // More than is counted is never taken in by pruning.
  folder.put("b.sdf", known_by_none(2));
  EXPECT_EQ(folder.rigor(kStrictly + "--baseline rigor.baseline --baseline-prune").exit, 1);
  EXPECT_EQ(baseline_entries(folder), "1 unknown-element a.sdf\n1 unknown-element b.sdf\n");
  EXPECT_EQ(folder.rigor("validate a.sdf --baseline rigor.baseline --baseline-strict").exit, 0);
}

TEST(CliBaseline, WritesWhatChangedAndKeepsWhatWasNotLookedAt) {
  const Folder folder;
  folder.put("a.sdf", known_by_none(1));
  folder.put("b.sdf", known_by_none(4));
  folder.rigor("validate --baseline-write rigor.baseline");
  folder.put("a.sdf", known_by_none(2, "<pose>wide</pose>"));
  const Ran again = folder.rigor("validate a.sdf --baseline-write rigor.baseline");
  EXPECT_EQ(again.exit, 0);
  EXPECT_NE(again.err.find("added 1 unknown-element a.sdf (1 before, 2 now)"), std::string::npos)
      << again.err;
  EXPECT_NE(again.err.find("added 1 value-malformed a.sdf"), std::string::npos) << again.err;
  EXPECT_EQ(baseline_entries(folder),
            "2 unknown-element a.sdf\n1 value-malformed a.sdf\n4 unknown-element b.sdf\n");
  folder.put("a.sdf", known_by_none(0));
  const Ran fewer = folder.rigor("validate a.sdf --baseline-write rigor.baseline");
  EXPECT_NE(fewer.err.find("removed 2 unknown-element a.sdf"), std::string::npos) << fewer.err;
  EXPECT_EQ(baseline_entries(folder), "4 unknown-element b.sdf\n");
}

TEST(CliBaseline, RefusesWhatIsNone) {
  const Folder folder;
  folder.put("a.sdf", known_by_none(1));
  folder.put("merged", "# known\n1 unknown-element a.sdf\n>>>>>>> theirs\n");
  const Ran merged = folder.rigor("validate --baseline merged");
  EXPECT_EQ(merged.exit, 2);
  EXPECT_NE(merged.err.find("merged:3: "), std::string::npos) << merged.err;
  EXPECT_EQ(folder.rigor("validate --baseline-write merged").exit, 2);
  const Ran missing = folder.rigor("validate --baseline none");
  EXPECT_EQ(missing.exit, 2);
  EXPECT_NE(missing.err.find("--baseline-write"), std::string::npos) << missing.err;
  EXPECT_EQ(folder.rigor("validate --baseline-prune").exit, 2);
  EXPECT_EQ(folder.rigor("validate --baseline-strict").exit, 2);
  EXPECT_EQ(folder.rigor("validate --baseline a --baseline-write a").exit, 2);
  // Nothing is written of a run that could not look at what was named.
  EXPECT_EQ(folder.rigor("validate a.sdf missing.sdf --baseline-write new").exit, 2);
  EXPECT_EQ(folder.get("new"), "");
}

}  // namespace
}  // namespace rigor::test
