// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <fmt/core.h>

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_normals_contradict {

void check(const MeshFile& file, Context& context) {
  const auto& stl = file.facts.asset.stl;
  if (!stl || stl->contrary_normals.count == 0 || file.collision()) return;
  const mesh::Sighting& contrary = stl->contrary_normals;
  report_mesh(file, context,
              fmt::format("{} of {} facets have a normal that points to the other side than the "
                          "order of the corners says, first {}",
                          contrary.count, stl->facets,
                          (stl->binary ? "facet " : "in line ") + std::to_string(contrary.first)));
}

Rule rule() {
  return {
      .name = "mesh-normals-contradict",
      .severity = Severity::kWarning,
      .summary = "normals of an STL contradict the order of its corners",
      .why = "Some viewers light a facet by its normal, and leave it out by the order of its "
             "corners: it is dark, or cannot be seen. Which of the two is right the file does not "
             "say; engines and mass properties go by the corners.",
      .what_to_do = "Turn the facets outward and write their normals anew: `rigor mesh-check FILE "
                    "--repair -o OUT.stl`.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_normals_contradict
