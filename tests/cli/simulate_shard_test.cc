// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A shard of `rigor simulate` reads its own models only: a thousand machines would each read all of them.

#include <cstdint>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "cli/program.h"

namespace rigor::test {
namespace {

std::string falling_box(const std::string& name) {
  return "<sdf version='1.9'><model name='" + name +
         "'><pose>0 0 0.05 0 0 0</pose><link "
         "name='l'><inertial><mass>1</mass><inertia><ixx>0.0017</ixx>"
         "<iyy>0.0017</iyy><izz>0.0017</izz></inertia></inertial><collision "
         "name='c'><geometry><box>"
         "<size>0.1 0.1 0.1</size></box></geometry></collision></link></model></sdf>\n";
}

/// A file over 64 MiB is refused with exit code 2 by whoever reads it, so the shards that pass have not.
TEST(SimulateShard, ReadsItsOwnModelsOnly) {
  const Folder folder;
  for (const char* name : {"a", "b", "c", "d"})
    folder.put("models/" + std::string(name) + ".sdf", falling_box(name));
  folder.put("models/broken.sdf", "");
  std::filesystem::resize_file(folder.path("models/broken.sdf"), std::uintmax_t{65} << 20U);
  const std::string simulate = "simulate models --no-confirm --fail-on never --shard ";
  int refused = 0;
  std::string lines;
  for (int shard = 1; shard <= 40; ++shard) {
    const Ran ran = folder.rigor(simulate + std::to_string(shard) + "/40 --format jsonl");
    refused += ran.exit == 2 ? 1 : 0;
    EXPECT_TRUE(ran.exit == 0 || ran.exit == 2) << ran.err;
    lines += ran.out;
  }
  EXPECT_EQ(refused, 1);
  for (const char* number : {"{\"index\":0,\"of\":5", "{\"index\":1,\"of\":5",
                             "{\"index\":3,\"of\":5", "{\"index\":4,\"of\":5"})
    EXPECT_NE(lines.find(number), std::string::npos) << number;
}

TEST(SimulateShard, ResumesNoLinesOfAnotherOne) {
  const Folder folder;
  for (const char* name : {"a", "b", "c", "d", "e", "f"})
    folder.put("models/" + std::string(name) + ".sdf", falling_box(name));
  const std::string simulate =
      "simulate models --no-confirm --fail-on never --resume --output jsonl:part.jsonl --shard ";
  EXPECT_EQ(folder.rigor(simulate + "1/2").exit, 0);
  const std::string first = folder.get("part.jsonl");
  ASSERT_FALSE(first.empty());
  EXPECT_EQ(folder.rigor(simulate + "1/2").exit, 0);
  EXPECT_EQ(folder.get("part.jsonl"), first);
  EXPECT_EQ(folder.rigor(simulate + "2/2").exit, 2);
  EXPECT_EQ(folder.get("part.jsonl"), first);
}

}  // namespace
}  // namespace rigor::test
