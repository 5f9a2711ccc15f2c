// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>
#include <string>

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_truncated {

void check(const MeshFile& file, Context& context) {
  const mesh::Fault* fault = fault_of(file, mesh::FaultKind::kTruncated);
  if (fault == nullptr) return;
  const std::uint64_t promised = file.facts.triangles + fault->count;
  report_mesh(file, context,
              file.facts.format == mesh::Format::kStlAscii
                  ? "the mesh ends within a facet" + in_line(fault->line)
                  : "the mesh promises " + how_many(promised, "triangle") + " and holds " +
                        std::to_string(file.facts.triangles) + in_line(fault->line));
}

Rule rule() {
  return {
      .name = "mesh-truncated",
      .severity = Severity::kError,
      .summary = "a mesh file is cut short",
      .why = "A copy, download or export was broken off. Assimp and MuJoCo refuse the file; admesh "
             "fills up what is missing with triangles of its own.",
      .what_to_do = "Get or export the whole file again.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_truncated
