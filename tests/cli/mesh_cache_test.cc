// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor mesh-check` with and without what an earlier run has kept.

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include <rigor/mass/mesh/cache.h>
#include <rigor/mesh/write/write.h>

#include <cli/program.h>
#include "support/meshes.h"

namespace rigor::test {
namespace {

/// A folder with a mesh that is just large enough to be kept, and one that is
/// not.
class MeshCacheCli : public testing::Test {
 protected:
  MeshCacheCli() {
    constexpr unsigned kAround = 50;
    static_assert(2 * kAround * 50 == mass::MeshCache::kMinTriangles);
    folder_.put("large.stl", *mesh::write_mesh(torus_mesh(2, 1, kAround, 50), "large.stl").bytes);
    folder_.put("small.stl", *mesh::write_mesh(torus_mesh(2, 1, kAround, 49), "small.stl").bytes);
  }

  Ran check(const std::string& arguments, const std::string& variables = "") const {
    return folder_.rigor("mesh-check large.stl small.stl --format json " + arguments,
                         "XDG_CACHE_HOME='" + folder_.path("cache") + "' " + variables);
  }

  std::size_t entries(const std::string& folder = "cache") const {
    std::error_code none;
    const std::filesystem::directory_iterator found(folder_.path(folder + "/rigor"), none);
    return static_cast<std::size_t>(std::distance(begin(found), end(found)));
  }

  Folder folder_;
};

void expect_same(const Ran& a, const Ran& b) {
  EXPECT_EQ(a.exit, b.exit);
  EXPECT_EQ(a.out, b.out);
  EXPECT_EQ(a.err, b.err);
}

TEST_F(MeshCacheCli, ColdWarmAndWithout) {
  const Ran without = check("--no-cache");
  EXPECT_EQ(entries(), 0U);
  expect_same(without, check("", "RIGOR_CACHE=off"));
  EXPECT_EQ(entries(), 0U);
  expect_same(without, check(""));
  EXPECT_EQ(entries(), 1U);
  expect_same(without, check(""));
  EXPECT_EQ(entries(), 1U);
}

TEST_F(MeshCacheCli, InTheHomeOfWhoHasNoOtherFolder) {
  const Ran without = check("--no-cache");
  const std::string home = "HOME='" + folder_.path("home") + "'";
  expect_same(without, check("", "XDG_CACHE_HOME= " + home));
  EXPECT_EQ(entries("home/.cache"), 1U);
  expect_same(without, check("", "XDG_CACHE_HOME=relative HOME="));
  EXPECT_FALSE(std::filesystem::exists(folder_.path("relative")));
  folder_.put("home2", "a file");
  expect_same(without, check("", "XDG_CACHE_HOME= HOME='" + folder_.path("home2") + "'"));
}

}  // namespace
}  // namespace rigor::test
