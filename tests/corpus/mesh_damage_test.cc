// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Real mesh files cut short, and with bits turned over, at ten thousand places: each is read, or refused
// with a reason, and whatever was read can be examined. Most are of the formats that rigor reads itself;
// each of the others takes a child process.

#include <algorithm>
#include <filesystem>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/mass/mesh/facts.h>
#include <rigor/mesh/collada/collada.h>
#include <rigor/text/disk.h>

#include "support/corpus.h"
#include "support/part.h"

namespace rigor {
namespace {

constexpr int kDamages = 10'000;
constexpr int kImportedEach = 20;  // one in so many is for the importer

// Of larger files there is nothing more to break, but more to wait for.
constexpr std::uintmax_t kMaxBytes = 30'000;

std::vector<std::string> small_files(const std::set<std::string>& endings) {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(test::corpus())) {
    if (!endings.contains(entry.path().extension().string())) continue;
    if (entry.file_size() > 0 && entry.file_size() <= kMaxBytes) {
      paths.push_back(entry.path().string());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::string damaged(std::string bytes, std::mt19937& random) {
  const auto below = [&random](std::size_t end) { return random() % end; };
  if (below(2) == 0) {
    bytes.resize(below(bytes.size()));
    return bytes;
  }
  for (std::size_t flips = 1 + below(8); flips > 0; --flips) {
    char& byte = bytes[below(bytes.size())];
    byte = static_cast<char>(static_cast<unsigned char>(byte) ^ (1U << below(8)));
  }
  return bytes;
}

TEST(CorpusRobustness, DamagedMeshesAreReadOrRefused) {
  RIGOR_NEEDS_CORPUS();
  const std::vector<std::string> own = small_files({".stl", ".STL", ".obj"});
  const std::vector<std::string> imported = small_files({".dae", ".DAE", ".glb", ".gltf", ".ply"});
  ASSERT_GT(own.size(), 50U);
  ASSERT_GT(imported.size(), 100U);
  const int damages = kDamages / static_cast<int>(test::parts());
  int read = 0;
  for (int i = 0; i < damages; ++i) {
    const auto& paths = i % kImportedEach == 0 ? imported : own;
    const std::string& path = paths[static_cast<std::size_t>(i) % paths.size()];
    SCOPED_TRACE(path + ", damage " + std::to_string(i));
    std::mt19937 random(static_cast<unsigned>(i));
    MemoryDisk disk;
    const std::string name = "mesh" + std::filesystem::path(path).extension().string();
    const std::string bytes = damaged(test::read_file(path), random);
    disk.put(name, bytes);
    const mass::MeshFacts facts = mass::mesh_facts(disk, name, mass::MeshDepth::kShape);
    EXPECT_EQ(facts.usable(), facts.shape.has_value());
    EXPECT_TRUE(facts.usable() || !facts.faults.empty());
    read += facts.usable() ? 1 : 0;
    if (i % kImportedEach == 0) mesh::read_collada(bytes);
  }
  EXPECT_GT(read, damages / 10);
}

}  // namespace
}  // namespace rigor
