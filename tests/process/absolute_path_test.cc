// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/process/absolute_path.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace rigor::process {
namespace {

TEST(AbsolutePath, IsFromTheRootAndNormalized) {
  EXPECT_EQ(absolute_path("/a/./b/../c.urdf"), "/a/c.urdf");
  const std::filesystem::path found = absolute_path("meshes/../arm.urdf");
  EXPECT_EQ(found, std::filesystem::current_path() / "arm.urdf");
}

}  // namespace
}  // namespace rigor::process
