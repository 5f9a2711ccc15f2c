// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_no_endsolid {

void check(const MeshFile& file, Context& context) {
  if (fault_of(file, mesh::FaultKind::kNoEndsolid) == nullptr) return;
  if (fault_of(file, mesh::FaultKind::kTruncated) != nullptr) return;  // that tells more
  report_mesh(file, context, "the STL ends without the word endsolid");
}

Rule rule() {
  return {
      .name = "mesh-no-endsolid",
      .severity = Severity::kInfo,
      .summary = "an STL in text ends without endsolid",
      .why = "Something may be missing at its end. RViz tells text from binary by that word, and "
             "reads the file as a binary one.",
      .what_to_do = "Export the mesh again if something is missing; else write it anew: `rigor "
                    "mesh-check FILE -o OUT.stl`.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_no_endsolid
