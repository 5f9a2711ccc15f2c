// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <vector>

#include <fmt/core.h>

#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_doubled_component {

void check(const MeshFile& file, Context& context) {
  if (file.visual()) return;
  const mass::MeshShape* shape = shape_of(file);
  if (!shape) return;
  const mesh::Topology& topology = shape->topology;
  if (topology.doubled == 0) return;
  std::vector<model::Vector3> places;
  for (const mesh::Component& component : topology.component_list) {
    if (component.nesting == mesh::Nesting::kDoubled) places.push_back(middle(component.bounds));
  }
  report_mesh(
      file, context,
      fmt::format("{} of {} separate pieces of the mesh {} inside another, so that what {} "
                  "counts twice,{}",
                  topology.doubled, topology.components, topology.doubled == 1 ? "lies" : "lie",
                  topology.doubled == 1 ? "it encloses" : "they enclose",
                  at_places(places, topology.doubled)));
}

Rule rule() {
  return {
      .name = "mesh-doubled-component",
      .severity = Severity::kInfo,
      .summary = "a closed piece of a mesh lies inside another and counts twice",
      .why = "It faces the same way as the piece around it, so it is not a cavity: what it "
             "encloses is matter twice. Gazebo's automatic inertia, MuJoCo's exact one and every "
             "sum over triangles count its volume twice; contacts never reach it.",
      .what_to_do = "Take the inner piece out; if it is meant as a hollow, turn its triangles "
                    "inward. Where a hull will do: `rigor mesh-check FILE --convex-hull -o OUT`.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_doubled_component
