// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_index_out_of_range {

void check(const MeshFile& file, Context& context) {
  const mesh::Fault* fault = fault_of(file, mesh::FaultKind::kIndexOutOfRange);
  if (fault == nullptr) return;
  report_mesh(file, context,
              fault->count > 0 ? how_many(fault->count, "corner") + " of faces name" +
                                     (fault->count == 1 ? "s" : "") +
                                     " a vertex that there is not" + in_line(fault->line)
                               : "a face names a vertex that there is not");
}

Rule rule() {
  return {
      .name = "mesh-index-out-of-range",
      .severity = Severity::kError,
      .summary = "a face names a vertex that there is not",
      .why = "Assimp refuses the whole mesh; a reader that does not look reads what lies behind "
             "its memory.",
      .what_to_do = "Export the mesh again: vertices are missing, or faces of another mesh got in.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_index_out_of_range
