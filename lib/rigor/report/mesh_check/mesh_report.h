// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What `mesh-check` prints: the facts of each mesh, the findings, and what was written.

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <rigor/author/mesh_operations.h>
#include <rigor/report/terminal/color.h>
#include <rigor/rules/mesh_check.h>
#include <rigor/text/sources.h>

namespace rigor::report {

struct WrittenFile {
  std::string path;
  std::optional<std::uint64_t> triangles = std::nullopt;  ///< of a mesh
  std::optional<double> hausdorff =
      std::nullopt;  ///< from the mesh before it was reduced, in its unit
};

struct MeshCheckReport {
  const rules::MeshCheckResult& result;
  const Sources& sources;
  std::vector<author::MeshStep> steps = {};
  std::optional<mesh::Fit> fit = std::nullopt;
  std::vector<WrittenFile> written = {};
};

std::string mesh_check_text(const MeshCheckReport& report, Color color);
std::string mesh_check_json(const MeshCheckReport& report);

}  // namespace rigor::report
