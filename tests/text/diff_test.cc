// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/diff.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/corpus.h"

namespace rigor {
namespace {

namespace fs = std::filesystem;

Edit edit(std::uint32_t begin, std::uint32_t end, const char* text) {
  return {{SourceId{0}, begin, end}, text};
}

TEST(Diff, OneLineChanged) {
  EXPECT_EQ(unified_diff("a.sdf", "one\ntwo\nthree\n", {edit(4, 7, "2")}),
            "--- a/a.sdf\n+++ b/a.sdf\n@@ -1,3 +1,3 @@\n one\n-two\n+2\n three\n");
}

TEST(Diff, LinesPutIn) {
  EXPECT_EQ(unified_diff("a", "one\ntwo\n", {edit(4, 4, "x\ny\n")}),
            "--- a/a\n+++ b/a\n@@ -1,2 +1,4 @@\n one\n+x\n+y\n two\n");
}

TEST(Diff, FileWithoutALineEndAtItsEnd) {
  EXPECT_EQ(unified_diff("a", "one", {edit(0, 3, "two")}),
            "--- a/a\n+++ b/a\n@@ -1,1 +1,1 @@\n-one\n\\ No newline at end of file\n+two\n"
            "\\ No newline at end of file\n");
}

TEST(Diff, NothingToDo) {
  EXPECT_EQ(unified_diff("a", "one\n", {}), "");
  EXPECT_EQ(unified_diff("a", "one\n", {edit(0, 3, "one")}), "");
}

/// `patch` is the judge: it must make of the old text what `apply_edits` does.
TEST(Diff, PatchUnderstandsIt) {
  if (std::system("patch --version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "patch is not installed";
  const fs::path folder = fs::path(testing::TempDir()) / "rigor_diff_test";
  fs::create_directories(folder);
  std::mt19937 random(7);
  const auto below = [&random](unsigned n) { return static_cast<std::uint32_t>(random() % n); };
  for (int round = 0; round < 100; ++round) {
    std::string text;
    const auto lines = 1 + random() % 60;
    for (unsigned i = 0; i < lines; ++i) text += "line " + std::to_string(random() % 9) + "\n";
    std::vector<Edit> edits;
    std::uint32_t at = 0;
    while (true) {
      at += below(150);
      const std::uint32_t end = at + below(12);
      if (end > text.size()) break;
      edits.push_back(edit(at, end, random() % 3 == 0 ? "a\nb" : ""));
      at = end + 1;
    }
    const std::string wanted = *apply_edits(text, edits);
    const std::string diff = unified_diff("f", text, edits);
    if (wanted == text) continue;
    std::ofstream(folder / "f") << text;
    std::ofstream(folder / "f.diff") << diff;
    const std::string command = "cd " + folder.string() + " && patch -s -p1 < f.diff";
    ASSERT_EQ(std::system(command.c_str()), 0) << text << "\n" << diff;
    EXPECT_EQ(test::read_file(folder / "f"), wanted) << diff;
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace rigor
