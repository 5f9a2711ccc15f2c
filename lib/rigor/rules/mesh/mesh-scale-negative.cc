// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>

#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_scale_negative {

void check(const MeshUse& use, Context& context) {
  const auto& scale = use.mesh.scale;
  const auto [x, y, z] = scale.value;
  if (!scale.written || (x >= 0 && y >= 0 && z >= 0)) return;
  // Through a point: no side of a robot is so the image of the other.
  const bool inverted = x < 0 && y < 0 && z < 0;
  context.report(
      {.where = scale.span,
       .message = inverted
                      ? "a scale that is negative along all axes turns the mesh inside out"
                      : "a negative scale mirrors the mesh: some readers then show it inside out",
       .subject = use.subject,
       .severity = inverted ? std::optional(Severity::kWarning) : std::nullopt});
}

Rule rule() {
  return {
      .name = "mesh-scale-negative",
      .severity = Severity::kInfo,
      .summary = "a mesh is scaled by a negative factor",
      .why = "Many robots use the meshes of one side mirrored on the other, and consumers differ: "
             "MuJoCo reverses the triangles; Gazebo Sim draws such a visual inside out and reports "
             "an error for such a collision (gazebosim/gz-sim#2656); Webots and O3DE reject the "
             "factor; some use its absolute value. Where all three are negative it is a warning: "
             "a side of a robot is mirrored in a plane, and not in a point.",
      .what_to_do = "Mirror the mesh file itself, with the winding of its triangles reversed, and "
                    "remove the minus signs.",
      .checks = {on<MeshUse>(check)},
  };
}

}  // namespace rigor::rules::mesh_scale_negative
