// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes in memory for as long as there is room, so that those who ask for one thing after another about a
// mesh need not read it again.
//
//   MeshReads reads(disk, environment.workers);
//   const auto loaded = reads.find("meshes/arm.dae");    // read
//   const auto same = reads.find("meshes/arm.dae");      // as it was

#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include <rigor/mesh/importer/scene.h>
#include <rigor/mesh/read.h>
#include <rigor/process/workers.h>
#include <rigor/text/disk.h>
#include <rigor/text/turns.h>

namespace rigor::mass {

class MeshReads {
 public:
  /// Of the meshes that a model uses, some ten million triangles.
  static constexpr std::uint64_t kMaxBytes = std::uint64_t{512} << 20U;

  /// Scenes are read by one of `workers`. All arguments outlive this.
  MeshReads(const Disk& disk, const process::Workers& workers, std::uint64_t max_bytes = kMaxBytes)
      : disk_(disk), workers_(workers), max_bytes_(max_bytes) {}
  /// For the threads of these turns: one who waits for a mesh lets others work.
  MeshReads(const Disk& disk, const process::Workers& workers, Turns& turns)
      : MeshReads(disk, workers) {
    turns_ = &turns;
  }

  Turns* turns() const { return turns_; }

  /// What `read_mesh` gives. Safe across threads: who asks for a mesh that is being read waits, who asks for
  /// another does not.
  std::shared_ptr<const mesh::LoadedMesh> find(const std::string& path);

 private:
  struct Entry {
    std::mutex reading;
    std::shared_ptr<const mesh::LoadedMesh> mesh;
    std::uint64_t bytes = 0;
  };
  using Used = std::list<std::pair<std::string, std::shared_ptr<Entry>>>;  // the latest first

  std::shared_ptr<Entry> entry_of(const std::string& path);
  void make_room();

  const Disk& disk_;
  const process::Workers& workers_;
  std::uint64_t max_bytes_;
  Turns* turns_ = nullptr;
  std::mutex mutex_;
  Used used_;
  std::map<std::string, Used::iterator> known_;
};

}  // namespace rigor::mass
