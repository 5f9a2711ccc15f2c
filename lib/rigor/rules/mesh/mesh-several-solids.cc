// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_several_solids {

void check(const MeshFile& file, Context& context) {
  const mesh::Fault* fault = fault_of(file, mesh::FaultKind::kSeveralSolids);
  if (fault == nullptr) return;
  report_mesh(file, context, "the STL holds " + how_many(fault->count, "solid"));
}

Rule rule() {
  return {
      .name = "mesh-several-solids",
      .severity = Severity::kInfo,
      .summary = "an STL holds several solids",
      .why = "Assimp makes a mesh of each; admesh refuses the file. Readers that stop at the first "
             "endsolid lose the others.",
      .what_to_do = "Make one solid of them: `rigor mesh-check FILE -o OUT.stl`. Or one file of "
                    "each: `--split component`.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_several_solids
