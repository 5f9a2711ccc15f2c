// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/gitignore.h>

#include <gtest/gtest.h>

namespace rigor {
namespace {

bool is_ignored(std::string_view patterns, std::string_view path, PathKind kind = PathKind::kFile) {
  const IgnorePatterns list(patterns);
  const IgnorePattern* last = list.last_match(path, kind);
  return last != nullptr && last->ignores;
}

// What follows is what `man gitignore` says, line by line.

TEST(Gitignore, BlankLinesAndCommentsSayNothing) {
  EXPECT_TRUE(IgnorePatterns("\n\r\n# build\n   \n").empty());
  EXPECT_TRUE(is_ignored("\\#build", "#build"));
}

TEST(Gitignore, SpacesAtTheEndCountBehindABackslashOnly) {
  EXPECT_TRUE(is_ignored("a  ", "a"));
  EXPECT_TRUE(is_ignored("a\\  ", "a "));
  EXPECT_FALSE(is_ignored("a\\ ", "a"));
  EXPECT_TRUE(is_ignored("a\\\\ ", "a\\"));
}

TEST(Gitignore, TheLastPatternDecides) {
  EXPECT_FALSE(is_ignored("*.sdf\n!keep.sdf", "keep.sdf"));
  EXPECT_TRUE(is_ignored("!keep.sdf\n*.sdf", "keep.sdf"));
  EXPECT_TRUE(is_ignored("\\!a", "!a"));
}

TEST(Gitignore, ASlashWithinTiesAPatternToItsFolder) {
  EXPECT_TRUE(is_ignored("doc/frotz/", "doc/frotz", PathKind::kFolder));
  EXPECT_FALSE(is_ignored("doc/frotz/", "a/doc/frotz", PathKind::kFolder));
  EXPECT_TRUE(is_ignored("frotz/", "a/frotz", PathKind::kFolder));
  EXPECT_TRUE(is_ignored("/a", "a"));
  EXPECT_FALSE(is_ignored("/a", "b/a"));
}

TEST(Gitignore, ASlashAtTheEndIsForFoldersOnly) {
  EXPECT_FALSE(is_ignored("build/", "build"));
  EXPECT_TRUE(is_ignored("build/", "build", PathKind::kFolder));
}

TEST(Gitignore, AStarStaysInAFolder) {
  EXPECT_TRUE(is_ignored("foo/*", "foo/test.json"));
  EXPECT_FALSE(is_ignored("foo/*", "foo/bar/hello.c"));
  EXPECT_TRUE(is_ignored("foo/**", "foo/bar/hello.c"));
  EXPECT_TRUE(is_ignored("**/foo/bar", "foo/bar"));
  EXPECT_TRUE(is_ignored("a/**/b", "a/b"));
  EXPECT_TRUE(is_ignored("a/**/b", "a/x/y/b"));
  EXPECT_FALSE(is_ignored("a/**/b", "ab"));
}

TEST(Gitignore, ALineIsKnown) {
  const IgnorePatterns list("\xEF\xBB\xBF# first\r\n\r\n!keep\r\n");
  const IgnorePattern* last = list.last_match("keep", PathKind::kFile);
  ASSERT_NE(last, nullptr);
  EXPECT_EQ(last->text, "!keep");
  EXPECT_EQ(last->line, 3U);
  EXPECT_FALSE(last->ignores);
}

TEST(Gitignore, AMegabyteOfStarsEnds) {
  std::string stars;
  for (int i = 0; i < 1024; ++i) stars += "*a*b*a*b*a*b*a*b*a*b*a*b*a*b*a*b*c/d\n";
  EXPECT_FALSE(is_ignored(stars, std::string(200, 'a') + "/" + std::string(50, 'b')));
  EXPECT_FALSE(is_ignored(std::string(1U << 20U, '*') + "b", "a"));
}

}  // namespace
}  // namespace rigor
