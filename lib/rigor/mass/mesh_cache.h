// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The facts of large meshes, kept in a folder from one run of a program to the next. They are those of
// the same bytes at the same path, as the same program with the same importer of scenes found them,
// and are used as long as everything else that was looked at (libraries of materials, buffers, pictures,
// names that were not there) is as it was. Whether there is a cache can be told from time alone.
//
//   const MeshCache cache(FolderStore("/home/me/.cache/rigor"), "rigor 0.1.0");
//   MeshFiles files(disk, MeshDepth::kAll, &cache);

#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <rigor/mass/mesh_facts.h>
#include <rigor/text/digest.h>
#include <rigor/text/disk.h>
#include <rigor/text/folder_store.h>
#include <rigor/text/witness.h>

namespace rigor::mass {

class MeshCache {
 public:
  /// The facts of fewer triangles are found in less than 50 ms.
  static constexpr std::uint64_t kLeastTriangles = 50'000;

  /// `program` tells apart programs that may find other facts in the same bytes.
  MeshCache(FolderStore store, std::string program, std::uint64_t least = kLeastTriangles)
      : store_(std::move(store)), program_(std::move(program)), least_(least) {}

  /// What `mesh_facts` gives.
  MeshFacts find(const Disk& disk, const std::string& path, MeshDepth depth) const;

 private:
  /// Of the file as it is now; nothing when none of its facts are kept.
  std::optional<Digest> key(const Disk& disk, const std::string& path, MeshDepth depth) const;
  bool keeps(const MeshFacts& facts) const;

  FolderStore store_;
  std::string program_;
  std::uint64_t least_;
};

/// An entry: facts, and what they hang on besides the mesh file.
struct CachedMeshFacts {
  std::vector<Witness> witnesses;
  std::string importer;  ///< of scenes; empty where none is needed
  MeshFacts facts;
};

}  // namespace rigor::mass
