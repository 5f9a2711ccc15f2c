// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/mesh/triangle_budget.h>
#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_collision_triangles {

void check(const MeshFile& file, Context& context) {
  if (!file.collision() || takes_part(file) || file.facts.triangles <= mesh::kMaxCollisionTriangles)
    return;
  report_mesh(file, context,
              fmt::format("the mesh has {} triangles, over {}: much for collisions",
                          file.facts.triangles, mesh::kMaxCollisionTriangles));
}

Rule rule() {
  return {
      .name = "mesh-collision-triangles",
      .severity = Severity::kWarning,
      .summary = "a mesh for collisions has more than 20 000 triangles",
      .why = "Each contact looks for those that touch, in every step: with so many a simulation "
             "may become slower than what it simulates. Of real meshes for collisions half have "
             "fewer than 500, and nine of ten fewer than 2 500.",
      .what_to_do = "Reduce it, `rigor mesh-check FILE --reduce 2000 -o OUT`, or take a hull, "
                    "`--convex-hull`, or primitives.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_collision_triangles
