// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>

#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_sliver {

void check(const MeshFile& file, Context& context) {
  if (file.use) return;  // half of all real meshes have some
  const mass::MeshShape* shape = shape_of(file);
  if (!shape) return;
  const mesh::Topology& topology = shape->topology;
  const std::uint64_t count = topology.slivers;
  if (count == 0) return;
  report_mesh(file, context,
              how_many(count, "triangle is", "triangles are") +
                  " a thousand times longer than high," +
                  at_defects(topology, mesh::Defect::kSliver, count));
}

Rule rule() {
  return {
      .name = "mesh-sliver",
      .severity = Severity::kInfo,
      .summary = "triangles of a mesh are very thin",
      .why = "They are a thousand times longer than high. Nothing breaks, but their normals are as "
             "good as their last digits, and reducing or cutting the mesh goes wrong there first. "
             "CAD programs make them along round edges.",
      .what_to_do = "Export with another tolerance, or mesh the part anew, where it matters.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_sliver
