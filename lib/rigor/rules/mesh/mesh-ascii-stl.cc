// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_ascii_stl {

void check(const MeshFile& file, Context& context) {
  if (!file.facts.usable() || file.facts.format != mesh::Format::kStlAscii) return;
  report_mesh(file, context, "the STL is written as text: RViz and MuJoCo read binary ones only");
}

Rule rule() {
  return {
      .name = "mesh-ascii-stl",
      .severity = Severity::kWarning,
      .summary = "an STL is written as text",
      .why = "RViz (\"can only load binary STL files\") and MuJoCo refuse it; Gazebo reads it. It "
             "is also about five times the size of a binary one, and takes as much longer to read.",
      .what_to_do = "Write it as a binary one: `rigor mesh-check FILE -o OUT.stl`.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_ascii_stl
