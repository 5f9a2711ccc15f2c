// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The memory that the import of a mesh may take, and the option that changes it.

#include <string>
#include <utility>

#include <gtest/gtest.h>

#include <cli/program.h>
#include "process/workers_fixture.h"

namespace rigor::test {
namespace {

/// A strip of triangles, 3 MiB of text: an importer keeps several times that.
std::string large_ply() {
  constexpr int kVertices = 100000;
  std::string ply = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(kVertices) +
                    "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                    std::to_string(kVertices - 2) +
                    "\nproperty list uchar int vertex_indices\nend_header\n";
  for (int i = 0; i < kVertices; ++i) {
    ply += std::to_string(i / 2) + (i % 2 == 0 ? " 0 0\n" : " 1 0\n");
  }
  for (int i = 2; i < kVertices; ++i) {
    ply +=
        "3 " + std::to_string(i - 2) + " " + std::to_string(i - 1) + " " + std::to_string(i) + "\n";
  }
  return ply;
}

TEST(MeshMemory, IsBoundedAndTheFindingNamesTheOption) {
  if (kUnderAddressSanitizer) GTEST_SKIP() << "no limit of memory under the sanitizer";
  const Folder folder;
  folder.put("strip.ply", large_ply());
  const Ran enough = folder.rigor("mesh-check strip.ply --format json --fail-on never --no-cache");
  EXPECT_EQ(enough.exit, 0) << enough.err;
  EXPECT_NE(enough.out.find("\"triangles\": 99998"), std::string::npos) << enough.out;
  EXPECT_EQ(enough.out.find("--mesh-memory"), std::string::npos) << enough.out;

  // assimp itself does not fit into 8 MiB; into 20 it does, the mesh does not.
  for (const auto& [gibibytes, told] :
       {std::pair("0.0078125", "8 MiB"), {"0.01953125", "20 MiB"}}) {
    const Ran little = folder.rigor("mesh-check strip.ply --format json --no-cache --mesh-memory " +
                                    std::string(gibibytes));
    EXPECT_EQ(little.exit, 1) << little.err;
    EXPECT_NE(little.out.find("needed more than " + std::string(told) +
                              " of memory (--mesh-memory allows more)"),
              std::string::npos)
        << little.out;
  }
}

TEST(MeshMemory, OfNoSizeIsAWrongInvocation) {
  const Folder folder;
  folder.put("strip.ply", "ply\n");
  for (const char* size : {"0", "-1", "much", "1025"}) {
    const Ran ran = folder.rigor("mesh-check strip.ply --mesh-memory " + std::string(size));
    EXPECT_EQ(ran.exit, 2) << size << ran.err;
    EXPECT_NE(ran.err.find("--mesh-memory"), std::string::npos) << size << ran.err;
  }
}

}  // namespace
}  // namespace rigor::test
