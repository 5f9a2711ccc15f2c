// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_scale_negative {

void check(const MeshUse& use, Context& context) {
  const auto& scale = use.mesh.scale;
  const auto [x, y, z] = scale.value;
  if (!scale.written || (x >= 0 && y >= 0 && z >= 0)) return;
  context.report({.where = scale.span,
                  .message =
                      "a negative scale mirrors the mesh: who does not turn its triangles back "
                      "sees it inside out",
                  .subject = use.subject});
}

Rule rule() {
  return {
      .name = "mesh-scale-negative",
      .severity = Severity::kWarning,
      .summary = "a mesh is scaled by a negative factor",
      .why = "Many robots make their left side of the meshes of the right one so, and consumers "
             "differ: MuJoCo turns the triangles back; new Gazebo draws such a visual with its "
             "inside outside and reports an error for such a collision (gazebosim/gz-sim#2656); "
             "Webots and O3DE refuse the factor; some take the absolute value.",
      .what_to_do = "Mirror the mesh file itself, with its triangles turned the right way round, "
                    "and take the minus signs out.",
      .checks = {on<MeshUse>(check)},
  };
}

}  // namespace rigor::rules::mesh_scale_negative
