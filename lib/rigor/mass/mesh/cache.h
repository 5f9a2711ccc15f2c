// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What was found of meshes, kept in a folder from one run of a program to the next. It is that of the
// same bytes at the same path, as the same program with the same importer of scenes found it,
// and is used as long as everything else that was examined (libraries of materials, buffers, pictures,
// names that were not there) is as it was. Whether there is a cache can be derived from time alone.
//
//   const MeshCache cache(FolderStore("/home/me/.cache/rigor"), "rigor 0.1.0", environment.workers);
//   MeshFiles files(disk, MeshDepth::kAll, {.cache = &cache});

#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <rigor/mass/mesh/facts.h>
#include <rigor/mass/mesh/reads.h>
#include <rigor/mass/mesh/survey.h>
#include <rigor/process/workers.h>
#include <rigor/text/digest.h>
#include <rigor/text/disk.h>
#include <rigor/text/store/file_stamp.h>
#include <rigor/text/store/folder_store.h>
#include <rigor/text/witness.h>

namespace rigor::mass {

struct CachedMesh;

class MeshCache {
 public:
  /// What the system says of the file at a path of the disk; see `stamp_of`.
  using Stamp = std::function<std::optional<FileStamp>(const std::string& path)>;

  /// Fewer triangles, in a format that rigor reads itself, are checked in some milliseconds, of which writing an
  /// entry would take more than a twentieth. Scenes are kept whatever their size: importing one takes a process.
  static constexpr std::uint64_t kMinTriangles = 5000;

  /// `program` distinguishes programs that may find something else in the same bytes. One of `workers`, which
  /// outlive this, is asked which importer there is. With `stamp`, for disks whose paths are the system's, a
  /// file's bytes are read once for their digest; without, whenever it is asked for.
  MeshCache(FolderStore store, std::string program, const process::Workers& workers,
            std::uint64_t least = kMinTriangles, Stamp stamp = {});

  /// What `mesh_facts` and `survey_mesh` give. Safe across threads.
  MeshFacts facts(const Disk& disk, const std::string& path, MeshDepth depth,
                  MeshReads* reads = nullptr) const;
  MeshSurvey survey(const Disk& disk, const MeshChoice& choice, MeshReads* reads = nullptr) const;

 private:
  class Importer;
  class Digests;

  template <class Found, class Find>
  Found find(const Disk& disk, const std::string& path, std::string_view what,
             const Find& find) const;
  /// Of the file as it is now; nothing when nothing of it is kept.
  std::optional<Digest> key(const Disk& disk, const std::string& path, std::string_view what) const;
  std::string importer_of(mesh::Format format) const;
  bool holds(const Disk& disk, const CachedMesh& entry) const;

  FolderStore store_;
  std::string program_;
  const process::Workers& workers_;
  std::uint64_t min_;
  std::shared_ptr<Importer> importer_;
  std::shared_ptr<Digests> digests_;
};

/// An entry: what was found, and what it hangs on besides the mesh file.
struct CachedMesh {
  std::vector<Witness> witnesses;
  std::string importer;  ///< of scenes; empty where none is needed
  std::variant<MeshFacts, MeshSurvey> found;
};

}  // namespace rigor::mass
