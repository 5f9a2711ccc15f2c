// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <random>
#include <string>

#include <rigor/lsp/document/text_difference.h>

namespace rigor::lsp {
namespace {

TEST(LspTextDifference, IsWhatWasTyped) {
  const TextChange change = difference("<link/>", "<link a/>");
  EXPECT_EQ(change.begin, 5U);
  EXPECT_EQ(change.end, 5U);
  EXPECT_EQ(change.size, 2U);
  const TextChange none = difference("same", "same");
  EXPECT_EQ(none.begin, none.end);
  EXPECT_EQ(none.size, 0U);
}

TEST(LspTextDifference, MakesTheOneTextTheOther) {
  std::mt19937 random(1);
  for (int i = 0; i < 500; ++i) {
    std::string before(random() % 20'000, ' ');
    for (char& c : before) c = static_cast<char>('a' + random() % 2);
    std::string after = before;
    const std::size_t begin = random() % (after.size() + 1);
    after.replace(begin, random() % 5, std::string(random() % 5, 'a'));
    const TextChange change = difference(before, after);
    ASSERT_LE(change.begin, change.end);
    ASSERT_LE(change.end, before.size());
    std::string made = before;
    made.replace(change.begin, change.end - change.begin, after.substr(change.begin, change.size));
    EXPECT_EQ(made, after);
  }
}

}  // namespace
}  // namespace rigor::lsp
