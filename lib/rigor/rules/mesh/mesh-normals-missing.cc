// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_normals_missing {

void check(const MeshFile& file, Context& context) {
  const mass::MeshFacts& facts = file.facts;
  const bool is_stl =
      facts.format == mesh::Format::kStlBinary || facts.format == mesh::Format::kStlAscii;
  if (!facts.usable() || is_stl || facts.normals || file.collision()) return;
  report_mesh(file, context, "the mesh has no normals: each viewer shades it as it thinks best");
}

Rule rule() {
  return {
      .name = "mesh-normals-missing",
      .severity = Severity::kInfo,
      .summary = "a visual mesh has no normals",
      .why = "Normals say whether an edge is to look sharp or round. Without them some viewers "
             "make all edges sharp, some make all round, and some draw the mesh black.",
      .what_to_do = "Write them: `rigor mesh-check FILE --normals 30 -o OUT.dae` makes edges of "
                    "less than 30° look round.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_normals_missing
