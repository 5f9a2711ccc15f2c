// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>

#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_nonmanifold_edge {

void check(const MeshFile& file, Context& context) {
  const mass::MeshShape* shape = shape_of(file);
  if (!shape) return;
  const mesh::Topology& topology = shape->topology;
  const std::uint64_t count = topology.nonmanifold_edges;
  if (count == 0) return;
  report_mesh(file, context,
              how_many(count, "edge has", "edges have") + " more than two triangles" +
                  at_defects(topology, mesh::Defect::kNonmanifoldEdge, count));
}

Rule rule() {
  return {
      .name = "mesh-nonmanifold-edge",
      .severity = Severity::kInfo,
      .summary = "edges of a mesh have more than two triangles",
      .why = "Walls without thickness and bodies that touch along an edge look like this. Which "
             "side of such an edge is inside is not defined there, so that booleans, hole filling "
             "and many mesh tools refuse the mesh or cut it there.",
      .what_to_do =
          "Keep touching bodies apart, and give walls a thickness. `rigor mesh-check FILE --repair "
          "-o OUT` takes away triangles that are there twice, a common cause.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_nonmanifold_edge
