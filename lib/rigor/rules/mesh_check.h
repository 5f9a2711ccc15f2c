// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Checks meshes: files by themselves, and those that models name, as they are placed there.
//
//   mass::MeshFiles files(disk, mass::MeshDepth::kAll);
//   MeshCheckResult result = mesh_check(environment, {.paths = {"hull.stl"}}, files, sources);
//   std::fputs(report::mesh_check_json(result, sources).c_str(), stdout);

#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/mass/mesh/facts.h>
#include <rigor/model/pose.h>
#include <rigor/read/discover.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>
#include <rigor/text/diagnostic.h>
#include <rigor/text/sources.h>

namespace rigor::rules {

struct MeshCheckOptions {
  /// Mesh files, models, and folders that hold models.
  std::vector<std::string> paths;
  Selection selection;  ///< when it selects nothing, the category `mesh`
  /// That of the mesh or model at a path, where they differ; `selection` is for all when empty.
  std::function<Selection(const std::string& path)> selection_for = {};
};

/// A mesh file at one scale.
struct CheckedMesh {
  const mass::MeshFacts* facts = nullptr;  ///< belongs to the `MeshFiles`
  model::Vector3 scale{1, 1, 1};
  std::vector<std::string> uses;  ///< "my_robot/link chassis/visual hull"; none of a file by itself
};

struct MeshCheckResult {
  std::vector<CheckedMesh> meshes;  ///< in the order of the paths, then of their first uses
  Diagnostics diagnostics;
  std::vector<read::LeftOut> left_out;  ///< in folders: templates, and what cannot be listed
  std::vector<std::string> unusable;    ///< arguments that do not exist or hold nothing to check
};

/// Whether a file's ending is a model's; any other file is taken for a mesh.
bool names_model(std::string_view path);

MeshCheckResult mesh_check(const Environment& environment, const MeshCheckOptions& options,
                           mass::MeshFiles& files, Sources& sources);

}  // namespace rigor::rules
