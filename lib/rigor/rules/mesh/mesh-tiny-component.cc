// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <vector>

#include <fmt/core.h>

#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_tiny_component {

// The smallest screw of a part is some hundredth of it.
constexpr double kTiny = 1e-3;

void check(const MeshFile& file, Context& context) {
  const mass::MeshShape* shape = shape_of(file);
  if (!shape) return;
  const mesh::Topology& topology = shape->topology;
  const double whole = mesh::diagonal(file.facts.bounds);
  std::vector<model::Vector3> places;
  for (const mesh::Component& component : topology.component_list) {
    if (mesh::diagonal(component.bounds) < kTiny * whole) {
      places.push_back(middle(component.bounds));
    }
  }
  if (places.empty()) return;
  report_mesh(file, context,
              fmt::format("{} of {} separate pieces of the mesh {} smaller than a thousandth of "
                          "it,{}",
                          places.size(), topology.components, places.size() == 1 ? "is" : "are",
                          at_places(places, places.size())));
}

Rule rule() {
  return {
      .name = "mesh-tiny-component",
      .severity = Severity::kInfo,
      .summary = "a mesh has crumbs: pieces a thousand times smaller than it",
      .why = "They are left over from cutting and exporting. Contacts catch on them, and a body's "
             "bounds or hull may hang on one.",
      .what_to_do = "Delete them in the tool that made the mesh.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_tiny_component
