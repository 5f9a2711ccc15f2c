// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/repository_ignores.h>

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace rigor::read {
namespace {

namespace fs = std::filesystem;

/// A repository in a temporary folder, with patterns and a tree of files made up by chance.
class MadeUpRepository {
 public:
  explicit MadeUpRepository(unsigned seed) : random_(seed) {
    std::string name = (fs::temp_directory_path() / "rigor-ignores-XXXXXX").string();
    root_ = ::mkdtemp(name.data());
    std::system(("git init -q '" + root_ + "'").c_str());
    grow("", 0);
    put(".git/info/exclude", some_patterns());
  }
  ~MadeUpRepository() {
    std::error_code ignored;
    fs::remove_all(root_, ignored);
  }
  MadeUpRepository(const MadeUpRepository&) = delete;
  MadeUpRepository& operator=(const MadeUpRepository&) = delete;

  std::set<std::string> ignored_by_git() const {
    std::string all;
    for (const auto& [path, kind] : entries_) all += path + '\0';
    put(".git/paths", all);
    const std::string git = "cd '" + root_ + "' && GIT_CONFIG_GLOBAL=/dev/null " +
                            "GIT_CONFIG_SYSTEM=/dev/null git check-ignore --no-index -z --stdin " +
                            "<.git/paths >.git/ignored";
    std::system(git.c_str());
    std::ifstream stream(root_ + "/.git/ignored", std::ios::binary);
    std::set<std::string> ignored;
    for (std::string path; std::getline(stream, path, '\0');) ignored.insert(path);
    return ignored;
  }

  std::string patterns_of(const std::string& path) const {
    std::string all;
    for (const auto& [file, patterns] : patterns_) all += "== " + file + "\n" + patterns + "\n";
    return path + "\n" + all;
  }

  const std::string& root() const { return root_; }
  const std::vector<std::pair<std::string, PathKind>>& entries() const { return entries_; }

 private:
  std::size_t below(std::size_t count) { return random_() % count; }

  std::string some_pattern() {
    static constexpr std::array<const char*, 30> kPieces{
        "a",          "b", "ab",   "b",    "a",     "*",       "*",           "**",
        "?",          "/", "/",    "/",    "[ab]",  "[!a]",    "[^b",         "[]",
        "[[:alpha:]", "]", "\\a",  "\\",   "[a-b]", "[b-a]",   "[[:digit:]]", "**/",
        "/**",        " ", "[-a]", "[a-]", "#",     "\xC3\xA9"};
    std::string pattern;
    if (below(4) == 0) pattern += '!';
    if (below(8) == 0) pattern += '/';
    for (std::size_t i = 1 + below(5); i > 0; --i) pattern += kPieces[below(kPieces.size())];
    if (below(5) == 0) pattern += '/';
    if (below(10) == 0) pattern += ' ';
    if (below(10) == 0) pattern += '\r';
    return pattern;
  }

  std::string some_patterns() {
    std::string text = below(8) == 0 ? "\xEF\xBB\xBF" : "";
    for (std::size_t i = below(5); i > 0; --i) text += some_pattern() + '\n';
    return text + (below(2) == 0 ? some_pattern() : "");
  }

  void put(const std::string& path, const std::string& bytes) const {
    std::ofstream(root_ + "/" + path, std::ios::binary) << bytes;
  }

  void grow(const std::string& folder, int depth) {
    if (below(3) == 0 || depth == 0) {
      const std::string file = folder + ".gitignore";
      patterns_.emplace_back(file, some_patterns());
      put(file, patterns_.back().second);
    }
    static constexpr std::array<const char*, 10> kNames{"a",   "b",  "ab", "ba",  "aab",
                                                        "a b", "#a", "a ", "b-a", "\xC3\xA9"};
    for (const char* name : kNames) {
      if (below(2) == 0) continue;
      const std::string path = folder + name;
      const bool is_folder = depth < 3 && below(3) == 0;
      entries_.emplace_back(path, is_folder ? PathKind::kFolder : PathKind::kFile);
      if (is_folder) {
        fs::create_directory(root_ + "/" + path);
        grow(path + "/", depth + 1);
      } else {
        put(path, "");
      }
    }
  }

  std::mt19937 random_;
  std::string root_;
  std::vector<std::pair<std::string, PathKind>> entries_;
  std::vector<std::pair<std::string, std::string>> patterns_;
};

// The judge is git itself.
TEST(RepositoryIgnores, AgreeWithGit) {
  if (std::system("git --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "git is not installed";
  std::size_t paths = 0;
  std::size_t ignored = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const MadeUpRepository made_up(seed);
    const std::set<std::string> expected = made_up.ignored_by_git();
    const RealDisk disk;
    RepositoryIgnores ignores(disk, {});
    for (const auto& [path, kind] : made_up.entries()) {
      const bool left_out =
          ignores.left_out_with_folders(made_up.root() + "/" + path, kind).has_value();
      ASSERT_EQ(left_out, expected.contains(path)) << "seed " << seed << made_up.patterns_of(path);
      ++paths;
      ignored += left_out ? 1 : 0;
    }
  }
  // Neither answer is rare.
  EXPECT_GT(paths, 1000U);
  EXPECT_GT(ignored, paths / 5);
  EXPECT_LT(ignored, paths * 4 / 5);
}

TEST(RepositoryIgnores, SayWhichLine) {
  MemoryDisk disk;
  disk.put("/w/.git/HEAD", "");
  disk.put("/w/.gitignore", "# ours\nbuild/\n");
  disk.put("/w/.git/info/exclude", "mine\n");
  disk.put("/w/arm/.gitignore", "!mine\n");
  RepositoryIgnores ignores(disk, {});
  EXPECT_EQ(ignores.left_out("/w/arm/build", PathKind::kFolder), "/w/.gitignore line 2: build/");
  EXPECT_EQ(ignores.left_out("/w/mine", PathKind::kFile), "/w/.git/info/exclude line 1: mine");
  EXPECT_FALSE(ignores.left_out("/w/arm/mine", PathKind::kFile));
  EXPECT_FALSE(ignores.left_out("/w/arm/build/a", PathKind::kFile));
  EXPECT_TRUE(ignores.left_out_with_folders("/w/arm/build/a", PathKind::kFile));
}

TEST(RepositoryIgnores, ARepositoryInAnotherIsOnItsOwn) {
  MemoryDisk disk;
  disk.put("/w/.git/HEAD", "");
  disk.put("/w/.gitignore", "*.sdf\nsrc/\n");
  disk.put("/w/src/arm/.git", "gitdir: ../../.git/modules/arm");
  RepositoryIgnores ignores(disk, {});
  EXPECT_TRUE(ignores.left_out_with_folders("/w/src/a.sdf", PathKind::kFile));
  EXPECT_FALSE(ignores.left_out_with_folders("/w/src/arm/a.sdf", PathKind::kFile));
}

TEST(RepositoryIgnores, OutsideOfOneOnlyTheTopFoldersCount) {
  MemoryDisk disk;
  disk.put("/home/.gitignore", "*\n");
  disk.put("/home/robot/.gitignore", "build/\n");
  RepositoryIgnores ignores(disk, {"/home/robot"});
  EXPECT_TRUE(ignores.left_out("/home/robot/build", PathKind::kFolder));
  EXPECT_TRUE(ignores.left_out("/home/robot/a/build", PathKind::kFolder));
  EXPECT_FALSE(ignores.left_out("/home/robot/a", PathKind::kFile));
  EXPECT_FALSE(ignores.left_out("/home/a", PathKind::kFile));
}

}  // namespace
}  // namespace rigor::read
