// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>

#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_duplicate_face {

void check(const MeshFile& file, Context& context) {
  const mass::MeshShape* shape = shape_of(file);
  if (!shape) return;
  const mesh::Topology& topology = shape->topology;
  const std::uint64_t count = topology.duplicates;
  if (count == 0) return;
  report_mesh(file, context,
              how_many(count, "triangle has", "triangles have") +
                  " the same corners as one before," +
                  at_defects(topology, mesh::Defect::kDuplicateFace, count));
}

Rule rule() {
  return {
      .name = "mesh-duplicate-face",
      .severity = Severity::kInfo,
      .summary = "triangles of a mesh are there twice",
      .why = "Drawn, the two flicker; in a volume they cancel or count twice; in contacts they "
             "cost twice. Programs such as SketchUp write each face once for its front and once "
             "for its back.",
      .what_to_do = "Keep one of each: `rigor mesh-check FILE --repair -o OUT`.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_duplicate_face
