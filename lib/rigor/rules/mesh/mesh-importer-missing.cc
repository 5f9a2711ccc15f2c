// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_importer_missing {

void check(const MeshFile& file, Context& context) {
  if (fault_of(file, mesh::FaultKind::kImporterMissing) != nullptr) {
    report_mesh(file, context, "the mesh is not looked at: assimp is not installed");
  }
  if (const mesh::Fault* fault = fault_of(file, mesh::FaultKind::kWorkerMissing)) {
    report_mesh(file, context, "the mesh is not looked at: the importer " + fault->detail);
  }
}

Rule rule() {
  return {
      .name = "mesh-importer-missing",
      .severity = Severity::kInfo,
      .summary = "a mesh is not looked at, for want of assimp",
      .why = "Collada, glTF, PLY and other scenes are read by assimp, which rigor looks for when "
             "it runs. Without it nothing is known of the mesh, neither good nor bad.",
      .what_to_do = "Install assimp 5 (Debian and Ubuntu: libassimp5).",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_importer_missing
