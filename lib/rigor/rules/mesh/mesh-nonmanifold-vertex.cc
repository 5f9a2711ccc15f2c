// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>

#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_nonmanifold_vertex {

void check(const MeshFile& file, Context& context) {
  const mass::MeshShape* shape = shape_of(file);
  if (!shape) return;
  const mesh::Topology& topology = shape->topology;
  const std::uint64_t count = topology.nonmanifold_vertices;
  if (count == 0) return;
  report_mesh(file, context,
              "parts of the surface touch in " + how_many(count, "vertex", "vertices") + " only" +
                  at_defects(topology, mesh::Defect::kNonmanifoldVertex, count));
}

Rule rule() {
  return {
      .name = "mesh-nonmanifold-vertex",
      .severity = Severity::kInfo,
      .summary = "parts of a mesh touch in a vertex only",
      .why = "The surface is pinched to a point. Tools that walk round a vertex see one of its "
             "parts only; some mesh libraries leave such triangles out.",
      .what_to_do = "Give each part a vertex of its own and move them apart, or join the parts.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_nonmanifold_vertex
