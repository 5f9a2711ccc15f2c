// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/results/parts.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "results/result_lines.h"

namespace rigor::results {
namespace {

std::string joined_lines(const std::vector<std::string>& lines) {
  std::string all;
  for (const std::string& line : lines) all += line + '\n';
  return all;
}

/// "v0 v1 s0": the order in which records come.
std::string order_of(const Parts& parts) {
  std::string order;
  const auto problem = parts.each([&](const Record& record) {
    const bool checked = std::holds_alternative<CheckedFile>(record);
    const Case& one = std::visit([](const auto& each) -> const Case& { return each.one; }, record);
    order += (checked ? " v" : " s") + std::to_string(one.index);
  });
  EXPECT_EQ(problem, std::nullopt);
  return order;
}

TEST(ResultParts, ComeInTheOrderOfTheirRuns) {
  std::vector<std::string> lines = lines_of_both(4);
  std::mt19937 random(1);
  for (int round = 0; round < 10; ++round) {
    std::shuffle(lines.begin(), lines.end(), random);
    const std::size_t cut = random() % (lines.size() + 1);
    const auto middle = lines.begin() + static_cast<std::ptrdiff_t>(cut);
    const MemoryDisk disk(
        {{"a", joined_lines({lines.begin(), middle})}, {"b", joined_lines({middle, lines.end()})}});
    Parts parts(disk);
    EXPECT_EQ(parts.add("b"), std::nullopt);
    EXPECT_EQ(parts.add("a"), std::nullopt);
    EXPECT_EQ(parts.sort().missing, 0U);
    EXPECT_EQ(order_of(parts), " v0 v1 v2 v3 s0 s1 s2 s3");
  }
}

TEST(ResultParts, MayBeLongerThanABlockAndEndWithoutALineBreak) {
  std::string blank(std::size_t{3} << 20U, ' ');
  const MemoryDisk disk({{"a", checked_line(0, 2) + blank + '\n' + checked_line(1, 2)}});
  Parts parts(disk);
  EXPECT_EQ(parts.add("a"), std::nullopt);
  EXPECT_EQ(parts.sort().missing, 0U);
  EXPECT_EQ(order_of(parts), " v0 v1");
}

TEST(ResultParts, NameWhatIsMissingAndDoubled) {
  const MemoryDisk disk({{"a", checked_line(0, 30) + '\n' + checked_line(5, 30) + '\n'},
                         {"b", checked_line(5, 30) + '\n' + simulated_line(1, 2) + '\n'}});
  Parts parts(disk);
  EXPECT_EQ(parts.add("a"), std::nullopt);
  EXPECT_EQ(parts.add("b"), std::nullopt);
  const Completeness found = parts.sort();
  EXPECT_EQ(found.missing, 28U + 1U);
  EXPECT_EQ(found.doubled, 1U);
  ASSERT_EQ(found.first_doubled.size(), 1U);
  EXPECT_EQ(found.first_doubled[0].first, "a:2");
  EXPECT_EQ(found.first_doubled[0].second, "b:1");
  EXPECT_EQ(found.first_missing.size(), kMaxListedCases);
  EXPECT_EQ(found.first_missing[0].index, 1U);
}

TEST(ResultParts, AreOfOneRunOfEachKind) {
  const MemoryDisk disk({{"a", checked_line(0, 30) + '\n' + checked_line(0, 31) + '\n'},
                         {"torn", simulated_line(0, 2).substr(0, 20)}});
  Parts parts(disk);
  EXPECT_EQ(parts.add("a"), "a:2: is of a run of 31 cases, not 30, of validate");
  EXPECT_EQ(parts.add("torn"), "torn:1: is not a result of a run");
  EXPECT_EQ(parts.add("none"), "none: cannot be read");
}

TEST(ResultParts, TellOfALineThatIsTornBehindItsHead) {
  const MemoryDisk disk({{"a", simulated_line(0, 1).substr(0, 100) + '\n'}});
  Parts parts(disk);
  EXPECT_EQ(parts.add("a"), std::nullopt);
  EXPECT_EQ(parts.sort().missing, 0U);
  EXPECT_EQ(parts.each([](const Record&) {}), "a:1: is not a result of a run");
}

}  // namespace
}  // namespace rigor::results
