// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The module that FCL is in: who loads it, and what is said where there is none.

#include <rigor/mesh/collide/collider_module.h>

#include <dlfcn.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include <rigor/process/worker_path.h>

namespace rigor::test {
namespace {

using mesh::OpenedColliders;

const char* const kFclLibrary = "libfcl.so";  // as a file names what it is linked to

TEST(ColliderModule, IsOpenedBesideTheWorker) {
  const OpenedColliders opened =
      mesh::open_colliders(process::path_beside_worker(mesh::kColliderModule));
  ASSERT_TRUE(opened.engine) << opened.problem;
  EXPECT_EQ(opened.problem, "");
  const auto ball = opened.engine->sphere(1);
  EXPECT_TRUE(opened.engine->collide(*ball, {}, *ball, {{1.9, 0, 0}, {}}));
  EXPECT_FALSE(opened.engine->collide(*ball, {}, *ball, {{2.1, 0, 0}, {}}));
}

TEST(ColliderModule, WhatIsNoneIsSaid) {
  const OpenedColliders none = mesh::open_colliders("/nowhere/rigor-collider.so");
  EXPECT_FALSE(none.engine);
  EXPECT_EQ(none.problem,
            "/nowhere/rigor-collider.so: cannot open shared object file: No such file or "
            "directory");
  const OpenedColliders other = mesh::open_colliders("libm.so.6");
  EXPECT_FALSE(other.engine);
  EXPECT_NE(other.problem.find("undefined symbol: rigor_make_collider_engine"), std::string::npos)
      << other.problem;
}

TEST(ColliderModule, AnotherVersionGetsNoEngine) {
  const std::string module = process::path_beside_worker(mesh::kColliderModule);
  void* handle = ::dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(handle, nullptr);
  const auto make = reinterpret_cast<decltype(&rigor_make_collider_engine)>(
      ::dlsym(handle, mesh::kMakeColliderEngine));
  ASSERT_NE(make, nullptr);
  EXPECT_EQ(make("0.0.0"), nullptr);
}

/// Loading FCL doubled the time that every command takes to start.
TEST(ColliderModule, AloneIsLinkedToFcl) {
  const auto names_fcl = [](const std::filesystem::path& file) {
    // At once: a program with sanitizers has half a gigabyte, which takes half a minute by characters.
    std::string bytes(std::filesystem::file_size(file), '\0');
    std::ifstream(file, std::ios::binary).read(bytes.data(), std::ssize(bytes));
    const std::string_view name = kFclLibrary;
    return ::memmem(bytes.data(), bytes.size(), name.data(), name.size()) != nullptr;
  };
  EXPECT_TRUE(names_fcl(process::path_beside_worker(mesh::kColliderModule)));
  EXPECT_FALSE(names_fcl(RIGOR_BINARY));
  EXPECT_FALSE(names_fcl(process::path_beside_worker("rigor-worker")));
}

}  // namespace
}  // namespace rigor::test
