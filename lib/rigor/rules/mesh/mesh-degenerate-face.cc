// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>
#include <vector>

#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_degenerate_face {

void check(const MeshFile& file, Context& context) {
  const mass::MeshShape* shape = shape_of(file);
  if (!shape) return;
  const mesh::Topology& topology = shape->topology;
  const std::uint64_t count = topology.degenerate + topology.zero_area;
  if (count == 0) return;
  std::vector<model::Vector3> places;
  for (const mesh::Example& example : topology.examples) {
    if (example.defect == mesh::Defect::kDegenerateFace ||
        example.defect == mesh::Defect::kZeroAreaFace) {
      places.push_back(example.at);
    }
  }
  report_mesh(
      file, context,
      how_many(count, "triangle has", "triangles have") + " no area," + at_places(places, count));
}

Rule rule() {
  return {
      .name = "mesh-degenerate-face",
      .severity = Severity::kInfo,
      .summary = "triangles of a mesh have no area",
      .why = "They have no normal, so that readers drop them or compute NaN; Gazebo drops them, "
             "glTF-Validator reports them. Two of their vertices coincide, or all three are on a "
             "line.",
      .what_to_do = "Take them out: `rigor mesh-check FILE --repair -o OUT`.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_degenerate_face
