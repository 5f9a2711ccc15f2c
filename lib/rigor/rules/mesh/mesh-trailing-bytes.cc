// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_trailing_bytes {

void check(const MeshFile& file, Context& context) {
  const mesh::Fault* fault = fault_of(file, mesh::FaultKind::kTrailingBytes);
  if (fault == nullptr) return;
  report_mesh(
      file, context,
      how_many(fault->count, "byte") + " stand behind the last triangle" + in_line(fault->line));
}

Rule rule() {
  return {
      .name = "mesh-trailing-bytes",
      .severity = Severity::kError,
      .summary = "a mesh file goes on behind its last triangle",
      .why = "A binary STL has 84 bytes and 50 for each triangle. Assimp, MuJoCo and admesh refuse "
             "a file of another size. Mostly a tool added data of its own, or a transfer added "
             "line breaks.",
      .what_to_do = "Write the file anew: `rigor mesh-check FILE -o OUT.stl`.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_trailing_bytes
