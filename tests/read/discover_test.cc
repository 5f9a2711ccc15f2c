// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/discover.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <rigor/read/repository_ignores.h>

namespace rigor::read {
namespace {

TEST(Discover, WalksFoldersAndTakesNamedFilesAsTheyAre) {
  MemoryDisk disk;
  for (const char* path : {"r/a.sdf", "r/b.SDF", "r/c.urdf", "r/d/model.config", "r/e.world",
                           "r/f.txt", "r/.git/g.sdf", "r/h.urdf.xacro", "r/i.sdf.erb", "r/j.erb"}) {
    disk.put(path, "");
  }
  const Discovered found = discover(disk, {"r", "r/f.txt", "r/a.sdf", "none"});
  EXPECT_EQ(found.files, (std::vector<std::string>{"r/a.sdf", "r/b.SDF", "r/c.urdf",
                                                   "r/d/model.config", "r/e.world", "r/f.txt"}));
  ASSERT_EQ(found.left_out.size(), 3U);
  EXPECT_EQ(found.left_out[0].path, "r/h.urdf.xacro");
  EXPECT_EQ(found.left_out[1].path, "r/i.sdf.erb");
  EXPECT_EQ(found.left_out[2].path, "r/j.erb");
  ASSERT_EQ(found.unusable.size(), 1U);
}

TEST(Discover, AFolderWithoutModelsIsNoUse) {
  MemoryDisk disk;
  disk.put("r/readme.txt", "");
  EXPECT_EQ(discover(disk, {"r"}).unusable.size(), 1U);
}

/// A repository with a bit of everything that is left out.
MemoryDisk ignoring_repository() {
  MemoryDisk disk;
  for (const char* path :
       {"/w/.git/HEAD", "/w/arm/a.sdf", "/w/arm/gen.sdf", "/w/build/b.sdf", "/w/ws/install/c.sdf",
        "/w/ws/install/COLCON_IGNORE", "/w/ws/d.urdf", "/w/vendor/e.sdf"}) {
    disk.put(path, "");
  }
  disk.put("/w/.gitignore", "build/\ngen.*\n");
  return disk;
}

std::vector<std::string> left_out_paths(const Discovered& found) {
  std::vector<std::string> paths;
  for (const LeftOut& left : found.left_out) paths.push_back(left.path);
  return paths;
}

TEST(Discover, WhatGitAndColconIgnoreIsPassedOver) {
  const MemoryDisk disk = ignoring_repository();
  EXPECT_EQ(discover(disk, {"/w"}).files,
            (std::vector<std::string>{"/w/arm/a.sdf", "/w/vendor/e.sdf", "/w/ws/d.urdf"}));
  // The file of patterns stands above the folder that is walked.
  EXPECT_EQ(discover(disk, {"/w/arm"}).files, std::vector<std::string>{"/w/arm/a.sdf"});
  const Discovered all = discover(disk, {"/w/arm"}, {.git_ignoring = GitIgnoring::kPassOver});
  EXPECT_EQ(all.files, (std::vector<std::string>{"/w/arm/a.sdf", "/w/arm/gen.sdf"}));
}

TEST(Discover, WhatIsNamedIsTaken) {
  const MemoryDisk disk = ignoring_repository();
  const std::vector<std::string> named{"/w/arm/gen.sdf", "/w/build/b.sdf", "/w/ws/install"};
  EXPECT_EQ(discover(disk, named).files,
            (std::vector<std::string>{"/w/arm/gen.sdf", "/w/build/b.sdf", "/w/ws/install/c.sdf"}));

  const Discovered judged = discover(disk, named, {.named = NamedPaths::kJudge});
  EXPECT_TRUE(judged.files.empty());
  EXPECT_TRUE(judged.unusable.empty());
  EXPECT_EQ(left_out_paths(judged), named);
  EXPECT_TRUE(judged.left_out[1].excluded);
  EXPECT_EQ(judged.left_out[1].why, "left out by /w/.gitignore line 1: build/");
}

TEST(Discover, RelativePathsLieInTheWorkingFolder) {
  MemoryDisk disk = ignoring_repository();
  disk.put("a.sdf", "");  // the memory's "." is where relative paths lead
  disk.put("gen.sdf", "");
  const Discovered found = discover(disk, {"."}, {.working_folder = "/w/arm"});
  EXPECT_EQ(std::count(found.files.begin(), found.files.end(), "gen.sdf"), 0);
  EXPECT_EQ(std::count(found.files.begin(), found.files.end(), "a.sdf"), 1);
}

TEST(Discover, WhatIsExcludedIsPassedOver) {
  const MemoryDisk disk = ignoring_repository();
  DiscoverOptions options;
  options.excluded = [](const std::string& path, PathKind) -> std::string {
    return path.starts_with("/w/vendor") ? "rigor.toml line 3: vendor/" : "";
  };
  EXPECT_EQ(discover(disk, {"/w"}, options).files,
            (std::vector<std::string>{"/w/arm/a.sdf", "/w/ws/d.urdf"}));
  EXPECT_EQ(discover(disk, {"/w/vendor/e.sdf"}, options).files.size(), 1U);
  options.named = NamedPaths::kJudge;
  EXPECT_EQ(left_out_paths(discover(disk, {"/w/vendor/e.sdf"}, options)),
            std::vector<std::string>{"/w/vendor/e.sdf"});
}

TEST(Discover, AFolderWhoseModelsAreAllLeftOutSaysSo) {
  MemoryDisk disk;
  disk.put("/r/.gitignore", "*.sdf\n");
  disk.put("/r/a.sdf", "");
  disk.put("/r/b.sdf", "");
  const Discovered found = discover(disk, {"/r"});
  ASSERT_EQ(found.unusable.size(), 1U);
  EXPECT_EQ(
      found.unusable[0],
      "/r: holds no .sdf, .world, .urdf, .srdf, .xacro or model.config but in what is left out: "
      "/r/a.sdf by "
      "/r/.gitignore line 1: *.sdf, and 1 more");
}

TEST(Discover, AFolderOfMjcfSaysThatItIsToBeNamed) {
  MemoryDisk disk;
  disk.put("/m/package.xml", "<package/>");
  disk.put("/m/arm/robot.xml", "<mujoco/>");
  disk.put("/p/package.xml", "<package/>");
  EXPECT_EQ(discover(disk, {"/m"}).unusable,
            std::vector<std::string>{
                "/m: holds no .sdf, .world, .urdf, .srdf, .xacro or model.config; MJCF "
                "is checked when it is named: /m/arm/robot.xml"});
  EXPECT_EQ(
      discover(disk, {"/p"}).unusable,
      std::vector<std::string>{"/p: holds no .sdf, .world, .urdf, .srdf, .xacro or model.config"});
}

TEST(Discover, AFileOfPatternsThatIsTooLongIsTold) {
  MemoryDisk disk;
  disk.put("/r/.git/HEAD", "");
  disk.put("/r/.gitignore", "*.sdf\n" + std::string(kMaxIgnoreBytes, '#'));
  disk.put("/r/arm/a.sdf", "");
  const Discovered found = discover(disk, {"/r/arm", "/r"}, {.working_folder = "/r/arm"});
  EXPECT_EQ(found.files, std::vector<std::string>{"/r/arm/a.sdf"});
  ASSERT_EQ(found.left_out.size(), 1U);
  EXPECT_EQ(found.left_out[0].path, "../.gitignore");
  EXPECT_EQ(found.left_out[0].why, "is larger than 256 KiB, so what it ignores is not passed over");
  EXPECT_TRUE(found.left_out[0].excluded);
  EXPECT_TRUE(discover(disk, {"/r"}, {.git_ignoring = GitIgnoring::kPassOver}).left_out.empty());
}

/// A disk one folder of which may not be listed.
class LockedDisk final : public Disk {
 public:
  LockedDisk(const Disk& disk, std::string locked) : disk_(disk), locked_(std::move(locked)) {}
  std::unique_ptr<OpenFile> open(const std::string& path) const override {
    return disk_.open(path);
  }
  ReadResult read(const std::string& path, std::uint64_t max_bytes) const override {
    return disk_.read(path, max_bytes);
  }
  PathKind kind(const std::string& path) const override { return disk_.kind(path); }
  std::vector<std::string> list(const std::string& folder) const override {
    return folder == locked_ ? std::vector<std::string>() : disk_.list(folder);
  }
  std::string obstacle(const std::string& path) const override {
    return path == locked_ ? "cannot be listed: permission denied" : "";
  }

 private:
  const Disk& disk_;
  std::string locked_;
};

TEST(Discover, AFolderThatCannotBeListedIsNotPassedOverInSilence) {
  MemoryDisk memory;
  memory.put("r/a.sdf", "");
  memory.put("r/locked/b.sdf", "");
  const LockedDisk disk(memory, "r/locked");

  const Discovered above = discover(disk, {"r"});
  EXPECT_EQ(above.files, std::vector<std::string>{"r/a.sdf"});
  EXPECT_EQ(left_out_paths(above), std::vector<std::string>{"r/locked"});
  EXPECT_EQ(above.left_out.at(0).why, "cannot be listed: permission denied");
  EXPECT_TRUE(above.unusable.empty());

  const Discovered itself = discover(disk, {"r/locked"});
  EXPECT_EQ(itself.unusable,
            std::vector<std::string>{"r/locked: cannot be listed: permission denied"});
  EXPECT_TRUE(itself.left_out.empty());

  MemoryDisk nothing_else;
  nothing_else.put("r/locked/b.sdf", "");
  const Discovered only = discover(LockedDisk(nothing_else, "r/locked"), {"r"});
  ASSERT_EQ(only.unusable.size(), 1U);
  EXPECT_NE(only.unusable[0].find("in what can be listed"), std::string::npos);
}

TEST(Discover, WhatLiesTooDeepIsNotPassedOverInSilence) {
  MemoryDisk disk;
  disk.put("w/a.sdf", "");
  std::string deep = "w";
  for (int i = 0; i < 70; ++i) deep += "/d";
  disk.put(deep + "/b.sdf", "");
  const Discovered found = discover(disk, {"w"});
  EXPECT_EQ(found.files, std::vector<std::string>{"w/a.sdf"});
  ASSERT_EQ(found.left_out.size(), 1U);
  EXPECT_TRUE(deep.starts_with(found.left_out[0].path));
}

TEST(Discover, ATemplateIsNamedAndLeft) {
  MemoryDisk disk;
  for (const char* name :
       {"w/a.sdf", "w/b.erb", "w/c.sdf.erb", "w/d.sdf.jinja", "w/e.html.jinja"}) {
    disk.put(name, "");
  }
  std::vector<std::string> left;
  for (const LeftOut& one : discover(disk, {"w"}).left_out) left.push_back(one.path);
  EXPECT_EQ(left, (std::vector<std::string>{"w/b.erb", "w/c.sdf.erb", "w/d.sdf.jinja"}));
}

TEST(Discover, SemanticDescriptionsAreNoModels) {
  MemoryDisk disk;
  for (const char* name : {"w/a.urdf", "w/a.srdf", "w/config/b.srdf", "v/only.srdf"}) {
    disk.put(name, "");
  }
  const Discovered found = discover(disk, {"w", "v"});
  EXPECT_EQ(found.files, std::vector<std::string>{"w/a.urdf"});
  EXPECT_EQ(found.semantic,
            (std::vector<std::string>{"w/a.srdf", "w/config/b.srdf", "v/only.srdf"}));
  EXPECT_TRUE(found.left_out.empty());
  EXPECT_TRUE(found.unusable.empty()) << "a folder of them alone is checked, too";
}

TEST(Discover, AFileIsMetOnceHoweverItIsNamed) {
  MemoryDisk disk;
  disk.put("a.sdf", "");
  disk.put("/w/a.sdf", "");
  const Discovered found =
      discover(disk, {"a.sdf", "/w/a.sdf", "./a.sdf"}, {.working_folder = "/w"});
  EXPECT_EQ(found.files, std::vector<std::string>{"a.sdf"});
}

TEST(Discover, WhatIsNotWantedIsNotTaken) {
  const MemoryDisk disk = ignoring_repository();
  DiscoverOptions options;
  options.wanted = [](const std::string& path) { return path.ends_with(".urdf"); };
  const Discovered found = discover(disk, {"/w", "/w/arm"}, options);
  EXPECT_EQ(found.files, std::vector<std::string>{"/w/ws/d.urdf"});
  EXPECT_TRUE(found.unusable.empty());
}

}  // namespace
}  // namespace rigor::read
