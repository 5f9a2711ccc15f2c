// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_empty {

void check(const MeshFile& file, Context& context) {
  if (fault_of(file, mesh::FaultKind::kEmpty) == nullptr) return;
  report_mesh(file, context,
              file.facts.bytes == 0 ? "the mesh file has no bytes" : "the mesh has no triangles");
}

Rule rule() {
  return {
      .name = "mesh-empty",
      .severity = Severity::kError,
      .summary = "a mesh file holds no triangles",
      .why = "Assimp, and so whoever reads by it, and MuJoCo refuse a mesh without triangles. "
             "Elsewhere nothing is seen and nothing is touched. It is mostly what an export left "
             "that failed.",
      .what_to_do = "Export the mesh again, or take the shape out.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_empty
