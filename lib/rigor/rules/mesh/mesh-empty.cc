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
      .why = "Assimp, all that use it, and MuJoCo reject a mesh without triangles. Elsewhere "
             "nothing is drawn and nothing collides. Mostly an export failed.",
      .what_to_do = "Export the mesh again, or remove the shape.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_empty
