// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/discover.h>

#include <gtest/gtest.h>

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
  ASSERT_EQ(found.left_out.size(), 2U);
  EXPECT_EQ(found.left_out[0].path, "r/h.urdf.xacro");
  EXPECT_EQ(found.left_out[1].path, "r/i.sdf.erb");
  ASSERT_EQ(found.unusable.size(), 1U);
}

TEST(Discover, AFolderWithoutModelsIsNoUse) {
  MemoryDisk disk;
  disk.put("r/readme.txt", "");
  EXPECT_EQ(discover(disk, {"r"}).unusable.size(), 1U);
}

}  // namespace
}  // namespace rigor::read
