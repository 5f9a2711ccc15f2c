// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The things that `rigor mesh-check` does, and what they share: the options, and the checks, which
// come first whatever is asked for.

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <rigor/author/mesh_operations.h>
#include <rigor/mass/mesh/facts.h>
#include <rigor/report/mesh_check/mesh_report.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/mesh_check.h>
#include <rigor/text/sources.h>

#include "option/mesh_operation_options.h"
#include "option/rule_settings.h"
#include "option/search.h"
#include "option/selection.h"
#include "output/output.h"
#include "output/progress.h"
#include "project/cache.h"

namespace rigor::tool {

struct MeshCheckArguments {
  std::vector<std::string> paths;
  std::string out;
  MeshOperationOptions operations;
  std::string attach;  ///< MODEL::LINK::SHAPE
  bool apply = false;
  bool test_world = false;
  OutputOptions output;
  ColorOption color;
  SelectionOptions selection;
  SearchOptions search;
  CacheOption cache;
};

/// What was done, to be told.
struct MeshWork {
  std::vector<author::MeshStep> steps = {};
  std::optional<mesh::Fit> fit = std::nullopt;
  std::vector<report::WrittenFile> written = {};
};

class MeshChecking {
 public:
  /// Checks all paths.
  explicit MeshChecking(const MeshCheckArguments& arguments);

  const Environment& environment() const { return environment_; }
  const Disk& disk() const { return disk_; }
  const Reach& reach() const { return real_.reach(); }
  const rules::MeshCheckResult& result() const { return result_; }

  /// All arguments are there, and all meshes could be read to their ends.
  bool whole() const;

  /// Prints what was found, and done, and returns the exit code.
  int conclude(const MeshWork& work = {}) const;

 private:
  const MeshCheckArguments& arguments_;
  std::vector<Target> targets_;
  GuardedDisk real_;
  ProgressDisk disk_;
  Environment environment_;
  RuleSettings settings_;
  std::optional<mass::MeshCache> cache_;
  mass::MeshFiles files_;
  Sources sources_;
  rules::MeshCheckResult result_;
};

/// Of a mesh with these facts.
author::MeshOperations operations_of(const MeshCheckArguments& arguments,
                                     const mass::MeshFacts& facts);

/// Who chose a file's name. A link is followed where the user named it.
enum class NamedBy : std::uint8_t { kUser, kRigor };

/// All files or none. Several meshes are numbered or named: hull-1.stl.
std::vector<report::WrittenFile> write_meshes(const author::OperatedMesh& done,
                                              const std::string& out, NamedBy named_by);

/// Operations on one mesh, written to a file, put into a model, or set into a world.
int work_on_mesh(const MeshCheckArguments& arguments);

/// A UsageError when `--attach` names no shape that can get a mesh.
void require_attachable(const MeshCheckArguments& arguments, const MeshChecking& checking);

/// Puts the mesh at `path` in the place of the shape that `--attach` names.
void attach(const MeshCheckArguments& arguments, const MeshChecking& checking,
            const std::string& path);

/// To `--out`, or else to stdout.
int write_test_world(const MeshCheckArguments& arguments, const MeshChecking& checking);

/// Operations on all meshes of a model, and the edits that go with them.
int apply_to_model(const MeshCheckArguments& arguments);

}  // namespace rigor::tool
