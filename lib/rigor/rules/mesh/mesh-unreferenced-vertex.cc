// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>

#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_unreferenced_vertex {

void check(const MeshFile& file, Context& context) {
  if (file.use) return;  // no contact comes from them
  const mass::MeshShape* shape = shape_of(file);
  if (!shape) return;
  const mesh::Topology& topology = shape->topology;
  const std::uint64_t count = topology.unreferenced;
  if (count == 0) return;
  report_mesh(file, context,
              how_many(count, "vertex is", "vertices are") + " used by no triangle," +
                  at_defects(topology, mesh::Defect::kUnreferencedVertex, count));
}

Rule rule() {
  return {
      .name = "mesh-unreferenced-vertex",
      .severity = Severity::kInfo,
      .summary = "vertices of a mesh are used by no triangle",
      .why = "They make the file larger, and programs that take bounds or a hull from all vertices "
             "get other ones than are seen.",
      .what_to_do = "Write the mesh anew, which leaves them out: `rigor mesh-check FILE -o OUT`.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_unreferenced_vertex
