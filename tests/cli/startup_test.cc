// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What every run of every command pays for.

#include <string>

#include <gtest/gtest.h>

#include <cli/program.h>

namespace rigor::test {
namespace {

/// By the dynamic loader's own account (man 8 ld.so). Relocating OpenSSL alone takes as long as a small model.
TEST(Startup, LoadsNothingThatOnlyOneCommandNeeds) {
  const Folder folder;
  const Ran ran = folder.rigor("--version", "LD_TRACE_LOADED_OBJECTS=1");
  ASSERT_NE(ran.out.find("libc.so"), std::string::npos) << ran.out;
  for (const char* library :
       {"libssl", "libcrypto", "libbrotli", "httplib", "libassimp", "libembree"}) {
    EXPECT_EQ(ran.out.find(library), std::string::npos) << library;
  }
}

}  // namespace
}  // namespace rigor::test
