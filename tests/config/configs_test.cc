// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/config/configs.h>

#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

namespace rigor::config {
namespace {

using Paths = std::vector<std::string>;

TEST(Configs, TheNearestFileAboveCounts) {
  MemoryDisk disk;
  disk.put("/home/p/rigor.toml", "fail-on = 'info'");
  disk.put("/home/p/models/arm/model.sdf", "");
  disk.put("/home/p/models/rigor.toml", "");
  const Configs configs(disk, "/home/p", {});
  EXPECT_EQ(configs.of("/home/p/models/arm/model.sdf").files, (Paths{"/home/p/models/rigor.toml"}));
  EXPECT_EQ(configs.of("models/arm").files, (Paths{"/home/p/models/rigor.toml"}));
  EXPECT_EQ(configs.of("models").files, (Paths{"/home/p/models/rigor.toml"}));
  EXPECT_EQ(configs.beside("models").files, (Paths{"/home/p/rigor.toml"}));
  EXPECT_EQ(configs.of("other.sdf").files, (Paths{"/home/p/rigor.toml"}));
  EXPECT_EQ(configs.of("../p/./other.sdf").files, (Paths{"/home/p/rigor.toml"}));
  EXPECT_EQ(configs.of("/home/x.sdf").files, Paths{});
  // Nothing of the file above it is in the nearest one.
  EXPECT_FALSE(configs.of("models/arm").fail_on);
}

TEST(Configs, TheSearchEndsAtTheRepositorysRoot) {
  MemoryDisk disk;
  disk.put("/rigor.toml", "");
  disk.put("/repo/.git/HEAD", "");
  disk.put("/repo/a.sdf", "");
  disk.put("/worktree/.git", "gitdir: elsewhere");
  const Configs configs(disk, "/", {});
  EXPECT_EQ(configs.of("/repo/a.sdf").files, Paths{});
  EXPECT_EQ(configs.of("/worktree/b/c.sdf").files, Paths{});
  EXPECT_EQ(configs.of("/a.sdf").files, (Paths{"/rigor.toml"}));
}

TEST(Configs, AFileMayBeNamedOrNone) {
  MemoryDisk disk;
  disk.put("/p/rigor.toml", "fail-on = 'info'");
  disk.put("/ci/strict.toml", "fail-on = 'warning'");
  const Configs named(disk, "/p", {ConfigChoice::Of::kFile, "../ci/strict.toml"});
  EXPECT_EQ(named.of("a.sdf").files, (Paths{"/ci/strict.toml"}));
  const Configs none(disk, "/p", {ConfigChoice::Of::kNone});
  EXPECT_EQ(none.of("a.sdf").files, Paths{});
  const Configs missing(disk, "/p", {ConfigChoice::Of::kFile, "no.toml"});
  ASSERT_EQ(missing.of("a.sdf").problems.size(), 1U);
  EXPECT_EQ(missing.of("a.sdf").problems.front().path, "/p/no.toml");
}

TEST(Configs, AChainOfFilesThatExtendEachOther) {
  MemoryDisk disk;
  disk.put("/rigor.toml", "fail-on = 'info'\nbaseline = 'b'\n[severity]\na = 'eror'\n");
  disk.put("/p/shared/base.toml", "extend = '../../rigor.toml'\nbaseline = 'c'\n");
  disk.put("/p/rigor.toml", "\nextend = 'shared/base.toml'\n[materials]\nfoam = 0\n");
  const Configs configs(disk, "/p", {});
  const Config& config = configs.of("a.sdf");
  EXPECT_EQ(config.files, (Paths{"/p/rigor.toml", "/p/shared/base.toml", "/rigor.toml"}));
  EXPECT_EQ(config.fail_on->place.path, "/rigor.toml");
  EXPECT_EQ(config.baseline->value, "/p/shared/c");
  EXPECT_EQ(config.extend->value, "shared/base.toml");
  ASSERT_EQ(config.problems.size(), 2U);
  EXPECT_EQ(config.problems[0].path, "/p/rigor.toml");
  EXPECT_EQ(config.problems[0].line, 4U);
  EXPECT_EQ(config.problems[1].path, "/rigor.toml");
  EXPECT_EQ(config.problems[1].line, 4U);
}

TEST(Configs, AChainMustEnd) {
  MemoryDisk disk;
  disk.put("/a/rigor.toml", "extend = '../b/rigor.toml'");
  disk.put("/b/rigor.toml", "\nextend = '../a/rigor.toml'");
  disk.put("/self/rigor.toml", "extend = 'rigor.toml'");
  disk.put("/lost/rigor.toml", "extend = 'nothing.toml'");
  disk.put("/folder/rigor.toml", "extend = '../a'");
  for (int i = 0; i < 100; ++i) {
    disk.put("/deep/" + std::to_string(i) + ".toml",
             "extend = '" + std::to_string(i + 1) + ".toml'\n");
  }
  disk.put("/deep/rigor.toml", "extend = '0.toml'");
  const Configs configs(disk, "/", {});
  const auto problem = [&configs](const std::string& path) {
    const Config& config = configs.of(path);
    if (config.problems.size() != 1) return std::to_string(config.problems.size()) + " problems";
    const Problem& one = config.problems.front();
    return one.path + ":" + std::to_string(one.line) + ": " + one.message;
  };
  EXPECT_EQ(problem("/a/x.sdf"),
            "/b/rigor.toml:2: extends itself: ../a/rigor.toml leads back here");
  EXPECT_EQ(problem("/self/x.sdf"), "/self/rigor.toml:1: extends itself");
  EXPECT_EQ(problem("/lost/x.sdf"), "/lost/rigor.toml:1: extend: nothing.toml: no such file");
  EXPECT_EQ(problem("/folder/x.sdf"), "/folder/rigor.toml:1: extend: ../a: is a folder");
  EXPECT_EQ(problem("/deep/x.sdf").substr(0, 14), "/deep/14.toml:");
  EXPECT_EQ(configs.of("/deep/x.sdf").files.size(), kMaxChain);
}

TEST(Configs, AFileThatIsTooLargeIsAProblem) {
  MemoryDisk disk;
  disk.put("/p/rigor.toml", std::string(kMaxConfigBytes + 1, '#'));
  const Configs configs(disk, "/p", {});
  EXPECT_EQ(configs.of("a.sdf").problems.size(), 1U);
}

/// Counts how often files are read.
class CountingDisk final : public Disk {
 public:
  explicit CountingDisk(const Disk& disk) : disk_(disk) {}
  std::unique_ptr<OpenFile> open(const std::string& path) const override {
    return disk_.open(path);
  }
  ReadResult read(const std::string& path, std::uint64_t max_bytes) const override {
    ++reads;
    return disk_.read(path, max_bytes);
  }
  PathKind kind(const std::string& path) const override {
    ++looks;
    return disk_.kind(path);
  }
  std::vector<std::string> list(const std::string& folder) const override {
    return disk_.list(folder);
  }
  mutable int reads = 0;  // under the lock of Configs
  mutable int looks = 0;

 private:
  const Disk& disk_;
};

TEST(Configs, EachFolderIsLookedAtOnceByAnyThread) {
  MemoryDisk memory;
  memory.put("/p/rigor.toml", "fail-on = 'info'");
  const CountingDisk disk(memory);
  const Configs configs(disk, "/p", {});
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&configs] {
      for (int i = 0; i < 1000; ++i) {
        const std::string folder = "a/" + std::to_string(i % 10);
        EXPECT_TRUE(configs.beside(folder + "/x.sdf").fail_on);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(disk.reads, 1);
  // Of ten folders and the one above them the file and .git, of /p the file.
  EXPECT_EQ(disk.looks, 2 * 11 + 1);
}

}  // namespace
}  // namespace rigor::config
