// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/write/safe_name.h>

#include <random>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace rigor::test {
using write::kMaxSafeName;
using write::safe_name;
using write::SafeNames;

namespace {

TEST(SafeName, KeepsWhatIsSafeAnywhere) {
  EXPECT_EQ(safe_name("wheel_2.L-Left"), "wheel_2.L-Left");
  EXPECT_EQ(safe_name("x/../../NAME"), "x_.._.._NAME");
  EXPECT_EQ(safe_name(".."), "__");
  EXPECT_EQ(safe_name("."), "_");
  EXPECT_EQ(safe_name(".hidden"), "_hidden");
  EXPECT_EQ(safe_name("-rf"), "_rf");
  EXPECT_EQ(safe_name(""), "_");
  EXPECT_EQ(safe_name("C:\\x y\n"), "C__x_y_");
  EXPECT_EQ(safe_name("\xC3\xA9"), "__");
}

TEST(SafeName, NoTwoAreTheSame) {
  SafeNames names;
  EXPECT_EQ(names.take("a/b"), "a_b");
  EXPECT_EQ(names.take("a:b"), "a_b-2");
  EXPECT_EQ(names.take("A_B"), "A_B-3");
  EXPECT_EQ(names.take("a_b-2"), "a_b-2-2");
}

/// Whatever the bytes: one part of a path, which no file system and no shell takes for anything else.
TEST(SafeName, OfRandomBytesIsOnePartOfAPath) {
  std::mt19937 random(1);  // NOLINT: the same bytes each time
  std::set<std::string> seen;
  SafeNames names;
  for (int round = 0; round < 2000; ++round) {
    std::string name(random() % 300, '\0');
    for (char& c : name) {
      c = random() % 4 == 0 ? "./\\-"[random() % 4] : static_cast<char>(random());
    }
    const std::string safe = names.take(name);
    EXPECT_TRUE(seen.insert(safe).second);
    EXPECT_LE(safe.size(), kMaxSafeName + 5);
    EXPECT_EQ(
        safe.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-"),
        std::string::npos);
    EXPECT_NE(safe.front(), '.');
    EXPECT_NE(safe.front(), '-');
  }
}

}  // namespace
}  // namespace rigor::test
