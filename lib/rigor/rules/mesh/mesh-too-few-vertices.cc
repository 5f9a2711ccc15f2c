// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_too_few_vertices {

void check(const MeshFile& file, Context& context) {
  const mass::MeshShape* shape = shape_of(file);
  if (!shape || shape->topology.vertices >= 4) return;
  report_mesh(file, context,
              fmt::format("the mesh has {} in different places that triangles use; a body has four "
                          "at least",
                          how_many(shape->topology.vertices, "vertex", "vertices")));
}

Rule rule() {
  return {
      .name = "mesh-too-few-vertices",
      .severity = Severity::kWarning,
      .summary = "a mesh has fewer than four vertices",
      .why = "A body has four at least: this one is a triangle. MuJoCo 3 rejects it; what has no "
             "thickness has no inside to collide with.",
      .what_to_do = "Export the whole part, or use a primitive.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_too_few_vertices
