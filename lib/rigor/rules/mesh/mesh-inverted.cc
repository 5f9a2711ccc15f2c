// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <vector>

#include <fmt/core.h>

#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_inverted {

/// A mirroring scale turns the mesh round once more.
bool mirrored(const MeshFile& file) {
  const auto [x, y, z] = file.scale();
  return x * y * z < 0;
}

/// What a mirroring node turns round depends on the reader: `mesh-mirrored-node`.
bool has_mirrored_node(const MeshFile& file) {
  const auto& collada = file.facts.asset.collada;
  return collada && collada->mirrored_nodes.count > 0;
}

void check(const MeshFile& file, Context& context) {
  const mass::MeshShape* shape = shape_of(file);
  if (!shape) return;
  const mesh::Topology& topology = shape->topology;
  if (topology.inverted == 0 || mirrored(file) || has_mirrored_node(file)) return;
  if (topology.components == 1) {
    report_mesh(
        file, context,
        "the mesh is inside out: its triangles face inward, so that its volume is negative");
    return;
  }
  std::vector<model::Vector3> places;
  for (const mesh::Component& component : topology.component_list) {
    if (component.inverted()) places.push_back(middle(component.bounds));
  }
  report_mesh(file, context,
              fmt::format("{} of {} separate pieces of the mesh {} inside out{}", topology.inverted,
                          topology.components, topology.inverted == 1 ? "is" : "are",
                          at_places(places, topology.inverted)));
}

Rule rule() {
  return {
      .name = "mesh-inverted",
      .severity = Severity::kWarning,
      .summary = "a closed mesh is inside out",
      .why = "All its triangles face inward. Its volume is negative, which MuJoCo, Drake and "
             "Gazebo's automatic inertia reject or turn into a wrong mass; viewers that cull back "
             "faces show its inside.",
      .what_to_do = "Turn its triangles round: `rigor mesh-check FILE --repair -o OUT`, or \"flip "
                    "normals\" in the tool that made it.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_inverted
