// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_solid_header {

void check(const MeshFile& file, Context& context) {
  if (fault_of(file, mesh::FaultKind::kSolidHeader) == nullptr) return;
  report_mesh(file, context, "the binary STL begins with the word solid, as those in text do");
}

Rule rule() {
  return {
      .name = "mesh-solid-header",
      .severity = Severity::kInfo,
      .summary = "a binary STL begins like one in text",
      .why = "Readers that go by the first word take the file for text. RViz warns at each start "
             "that the file is malformed. One in eight binary STL files is like that: SolidWorks "
             "writes them.",
      .what_to_do = "Write the file anew: `rigor mesh-check FILE -o OUT.stl`.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_solid_header
