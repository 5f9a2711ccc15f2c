// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_too_large {

void check(const MeshFile& file, Context& context) {
  const mesh::Fault* fault = fault_of(file, mesh::FaultKind::kTooLarge);
  if (fault == nullptr) return;
  report_mesh_text(file, context,
                   "the mesh is too large to be read: " +
                       (fault->detail.empty() ? "over 50 million triangles" : fault->detail));
}

Rule rule() {
  return {
      .name = "mesh-too-large",
      .severity = Severity::kError,
      .summary = "a mesh file is too large to be read",
      .why =
          "Files over 2 GiB and meshes of more than 50 million triangles are not opened. The "
          "largest among some thousand meshes of robots has 30 MB; simulators would take minutes "
          "and gigabytes for such a one, and MuJoCo rejects more than 200 000 triangles.",
      .what_to_do = "Reduce the mesh where it comes from, by a coarser export.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_too_large
