// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_not_finite {

void check(const MeshFile& file, Context& context) {
  const mesh::Fault* fault = fault_of(file, mesh::FaultKind::kNotFinite);
  if (fault == nullptr) return;
  report_mesh_text(
      file, context,
      how_many(fault->count, "coordinate") + (fault->count == 1 ? " is" : " are") +
          " NaN or infinite" +
          (fault->detail.empty() ? in_line(fault->line) : ", first in " + fault->detail));
}

Rule rule() {
  return {
      .name = "mesh-not-finite",
      .severity = Severity::kError,
      .summary = "a mesh has coordinates that are no finite numbers",
      .why = "MuJoCo rejects the mesh. Assimp passes NaN on: bounding boxes, inertia and contacts "
             "become NaN.",
      .what_to_do =
          "Export the mesh again; a modifier or a scale of zero there is the usual cause.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_not_finite
