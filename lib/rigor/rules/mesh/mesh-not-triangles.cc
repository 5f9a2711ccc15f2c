// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_not_triangles {

void check(const MeshFile& file, Context& context) {
  if (file.visual()) return;  // drawings often have edges drawn over them
  const mesh::Fault* fault = fault_of(file, mesh::FaultKind::kNotTriangles);
  if (fault == nullptr) return;
  report_mesh(file, context,
              how_many(fault->count, "element") + in_line(fault->line) +
                  (fault->count == 1 ? " is a line or a point" : " are lines or points") +
                  ", which nothing can touch");
}

Rule rule() {
  return {
      .name = "mesh-not-triangles",
      .severity = Severity::kInfo,
      .summary = "a collision mesh holds lines or points",
      .why =
          "Only faces can be touched: engines drop lines and points, or stumble over faces with "
          "less than three corners. About one Collada file in ten has some, mostly from SketchUp.",
      .what_to_do = "Write the mesh anew, which drops them: `rigor mesh-check FILE -o OUT.stl`.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_not_triangles
