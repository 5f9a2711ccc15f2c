// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which mesh files a model's shapes use, with the digests of their bytes: found once a file, however many models use it.
//
//   MeshList list(disk, files, turns);
//   const std::vector<OpenedMesh> meshes = list.of(root, [&](const std::string& uri) { return resolved(uri); });

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <rigor/mass/mesh/facts.h>
#include <rigor/mass/mesh/opened_mesh.h>
#include <rigor/model/model.h>
#include <rigor/text/disk.h>
#include <rigor/text/found_once.h>

namespace rigor::mass {

class MeshList {
 public:
  /// All arguments outlive this.
  MeshList(const Disk& disk, MeshFiles& files, Turns* turns)
      : disk_(disk), files_(files), known_(turns) {}

  using FindPath = std::function<std::optional<std::string>(const std::string& uri)>;

  /// Of the shapes that the file itself holds, each path once, sorted; without those that are not there. Safe across
  /// threads.
  std::vector<OpenedMesh> of(const model::Root& root, const FindPath& find);

 private:
  const Disk& disk_;
  MeshFiles& files_;
  FoundOnce<std::string, std::optional<OpenedMesh>> known_;
};

}  // namespace rigor::mass
