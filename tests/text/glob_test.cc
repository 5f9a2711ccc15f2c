// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/glob.h>

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <utility>
#include <vector>

namespace rigor {
namespace {

bool glob_matches(std::string_view pattern, std::string_view path) {
  return Glob(pattern).matches(path);
}

/// By the definition, trying one way after the other: right, and slow.
bool tried_by_hand(std::string_view pattern, std::string_view path, bool part_begins = true) {
  if (pattern.empty()) return path.empty();
  if (pattern == "**" && part_begins) return true;
  if (pattern.starts_with("**/") && part_begins) {
    if (tried_by_hand(pattern.substr(3), path)) return true;
    for (std::size_t i = 0; i < path.size(); ++i) {
      if (path[i] == '/' && tried_by_hand(pattern.substr(3), path.substr(i + 1))) return true;
    }
    return false;
  }
  if (pattern.front() == '*') {
    for (std::size_t i = 0;; ++i) {
      const std::string_view rest =
          pattern.substr(pattern.find_first_not_of('*') == std::string_view::npos
                             ? pattern.size()
                             : pattern.find_first_not_of('*'));
      if (tried_by_hand(rest, path.substr(i), false)) return true;
      if (i == path.size() || path[i] == '/') return false;
    }
  }
  if (path.empty()) return false;
  const bool one = pattern.front() == '?' ? path.front() != '/' : pattern.front() == path.front();
  return one && tried_by_hand(pattern.substr(1), path.substr(1), pattern.front() == '/');
}

TEST(Glob, Wildcards) {
  EXPECT_TRUE(glob_matches("worlds/*.sdf", "worlds/lab.sdf"));
  EXPECT_FALSE(glob_matches("worlds/*.sdf", "worlds/old/lab.sdf"));
  EXPECT_TRUE(glob_matches("worlds/**/*.sdf", "worlds/lab.sdf"));
  EXPECT_TRUE(glob_matches("worlds/**/*.sdf", "worlds/old/1/lab.sdf"));
  EXPECT_FALSE(glob_matches("worlds/**/lab.sdf", "worlds/my_lab.sdf"));
  EXPECT_TRUE(glob_matches("worlds/**", "worlds/a/b"));
  EXPECT_FALSE(glob_matches("worlds/**", "worlds"));
  EXPECT_TRUE(glob_matches("**/a", "a"));
  EXPECT_TRUE(glob_matches("**", "a/b"));
  EXPECT_FALSE(glob_matches("a**b", "a/b")) << "only as a whole part does ** go over parts";
  EXPECT_TRUE(glob_matches("a**b", "axb"));
  EXPECT_TRUE(glob_matches("lab?.sdf", "lab1.sdf"));
  EXPECT_FALSE(glob_matches("lab?sdf", "lab/sdf"));
  EXPECT_TRUE(glob_matches("a\\*", "a*"));
  EXPECT_FALSE(glob_matches("a\\*", "ab"));
}

TEST(Glob, Sets) {
  EXPECT_TRUE(glob_matches("lab[0-9].sdf", "lab7.sdf"));
  EXPECT_FALSE(glob_matches("lab[0-9].sdf", "labx.sdf"));
  EXPECT_TRUE(glob_matches("[!a-c]", "d"));
  EXPECT_FALSE(glob_matches("[^a-c]", "b"));
  EXPECT_TRUE(glob_matches("[]x]", "]"));
  EXPECT_TRUE(glob_matches("[a-]", "-"));
  EXPECT_TRUE(glob_matches("[\\]]", "]"));
  EXPECT_TRUE(glob_matches("[[:digit:]x]", "4"));
  EXPECT_TRUE(glob_matches("[[:digit:]x]", "x"));
  EXPECT_FALSE(glob_matches("[[:digit:]]", "x"));
  EXPECT_FALSE(glob_matches("a[!x]b", "a/b")) << "a set never holds the slash";
}

TEST(Glob, SaysWhatItCannotMatch) {
  for (const char* broken : {"[a", "a\\", "[[:nothing:]]", "[a-", "[\\"}) {
    EXPECT_FALSE(Glob(broken).usable()) << broken;
    EXPECT_FALSE(Glob(broken).matches(broken)) << broken;
  }
  EXPECT_FALSE(Glob(std::string(kMaxPatternBytes + 1, 'a')).usable());
}

TEST(Glob, IsWhatItsDefinitionSays) {
  std::mt19937 random(7);
  const auto text = [&random](const std::string& letters, std::size_t most) {
    std::string made;
    for (std::size_t n = random() % most + 1; n > 0; --n)
      made += letters[random() % letters.size()];
    return made;
  };
  int matched = 0;
  for (int i = 0; i < 200'000; ++i) {
    const std::string pattern = text("aab**?//", 8);
    const std::string path = text("aaabb/", 7);
    const bool wanted = tried_by_hand(pattern, path);
    matched += wanted ? 1 : 0;
    // A run of three stars is one of two: the definition above knows two only.
    if (pattern.find("***") != std::string::npos) continue;
    ASSERT_EQ(glob_matches(pattern, path), wanted) << pattern << "  " << path;
  }
  EXPECT_GT(matched, 1000);
}

TEST(Glob, ManyStarsCostNoMoreThanTheirNumber) {
  // Tried one after the other, these ways are more than there is time for.
  std::string stars;
  for (int i = 0; i < 60; ++i) stars += "*a";
  EXPECT_FALSE(glob_matches(stars + "b", std::string(4000, 'a')));
  std::string folders;
  for (int i = 0; i < 60; ++i) folders += "**/a/";
  std::string path;
  for (int i = 0; i < 2000; ++i) path += "a/";
  EXPECT_FALSE(glob_matches(folders + "b", path + "c"));
  EXPECT_TRUE(glob_matches(folders + "c", path + "c"));
}

}  // namespace
}  // namespace rigor
