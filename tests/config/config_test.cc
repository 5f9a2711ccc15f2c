// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/config/config.h>

#include <gtest/gtest.h>

namespace rigor::config {
namespace {

TEST(Config, TheNearestFileAboveCounts) {
  MemoryDisk disk;
  disk.put("/home/p/rigor.toml", "");
  disk.put("/home/p/models/arm/model.sdf", "");
  disk.put("/home/p/models/rigor.toml", "");
  EXPECT_EQ(find_config(disk, "/home/p/models/arm/model.sdf", "/"), "/home/p/models/rigor.toml");
  EXPECT_EQ(find_config(disk, "models/arm", "/home/p"), "/home/p/models/rigor.toml");
  EXPECT_EQ(find_config(disk, "other.sdf", "/home/p"), "/home/p/rigor.toml");
}

TEST(Config, TheSearchEndsAtTheRepositorysRoot) {
  MemoryDisk disk;
  disk.put("/rigor.toml", "");
  disk.put("/repo/.git/HEAD", "");
  disk.put("/repo/a.sdf", "");
  EXPECT_EQ(find_config(disk, "/repo/a.sdf", "/"), std::nullopt);
  EXPECT_EQ(find_config(disk, "/a.sdf", "/"), "/rigor.toml");
}

TEST(Config, Materials) {
  const Config config = read_config("rigor.toml", "[materials]\nour-foam = 42\nink = 1.1e3\n");
  EXPECT_TRUE(config.problems.empty());
  EXPECT_EQ(config.materials.at("our-foam"), 42);
  EXPECT_EQ(config.materials.at("ink"), 1100);
}

TEST(Config, WhatCannotStandThereHasALine) {
  const auto line = [](std::string_view text) {
    const Config config = read_config("rigor.toml", text);
    return config.problems.empty() ? 0U : config.problems.front().line;
  };
  EXPECT_EQ(line("[materials]\nfoam = -1\n"), 2U);
  EXPECT_EQ(line("[materials]\nfoam = 'light'\n"), 2U);
  EXPECT_EQ(line("[materials]\n\nfoam = inf\n"), 3U);
  EXPECT_EQ(line("materials = 3\n"), 1U);
  EXPECT_EQ(line("\n\n[materials\n"), 3U);
  EXPECT_EQ(line(""), 0U);
}

}  // namespace
}  // namespace rigor::config
