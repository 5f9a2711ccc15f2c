// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>
#include <string>

#include <fmt/core.h>

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_normals_contradict {

// One facet of so many is a sliver, whose normal is rounding.
constexpr std::uint64_t kFewest = 1000;

void check(const MeshFile& file, Context& context) {
  const auto& stl = file.facts.asset.stl;
  if (!stl || stl->contrary_normals.count == 0 || file.collision()) return;
  const mesh::Sighting& contrary = stl->contrary_normals;
  if (contrary.count * kFewest < stl->facets) return;
  report_mesh(file, context,
              fmt::format("{} of {} facets have a normal that contradicts the winding of their "
                          "vertices, first {}",
                          contrary.count, stl->facets,
                          (stl->binary ? "facet " : "in line ") + std::to_string(contrary.first)));
}

Rule rule() {
  return {
      .name = "mesh-normals-contradict",
      .severity = Severity::kWarning,
      .summary = "facet normals of an STL contradict the winding of its vertices",
      .why = "Some viewers light a facet by its normal and cull it by its winding: it is dark or "
             "invisible. The file does not tell which of the two is right; engines and mass "
             "properties use the winding. Fewer than one facet in 1000 is not reported: those are "
             "slivers.",
      .what_to_do =
          "Orient the facets outward and compute their normals again: `rigor mesh-check FILE "
          "--repair -o OUT.stl`.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_normals_contradict
