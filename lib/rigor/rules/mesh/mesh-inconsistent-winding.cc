// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>

#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_inconsistent_winding {

void check(const MeshFile& file, Context& context) {
  const mass::MeshShape* shape = shape_of(file);
  if (!shape) return;
  const mesh::Topology& topology = shape->topology;
  const std::uint64_t count = topology.inconsistent_edges;
  if (count == 0) return;
  report_mesh(file, context,
              "at " + how_many(count, "edge", "edges") + " the two triangles face opposite ways," +
                  at_defects(topology, mesh::Defect::kInconsistentEdge, count));
}

Rule rule() {
  return {
      .name = "mesh-inconsistent-winding",
      .severity = Severity::kWarning,
      .summary = "neighboring triangles of a mesh face opposite ways",
      .why = "Where neighbors disagree, one of them is drawn from the inside or not at all, pushes "
             "contacts the wrong way in engines that use it, and is subtracted from volume and "
             "inertia. The order of a triangle's vertices (its winding) defines the outside. Newer "
             "MuJoCo refuses to compute an exact inertia from such a mesh.",
      .what_to_do = "Turn the triangles the same way: `rigor mesh-check FILE --repair -o OUT`, or "
                    "\"recalculate normals outside\" in the tool that made it.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_inconsistent_winding
