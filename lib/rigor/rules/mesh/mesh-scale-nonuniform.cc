// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_scale_nonuniform {

// Factors of 0.0254 and 0.02540 are the same.
constexpr double kRounded = 1.001;

void check(const MeshUse& use, Context& context) {
  const auto& scale = use.mesh.scale;
  const double x = std::abs(scale.value.x);
  const double y = std::abs(scale.value.y);
  const double z = std::abs(scale.value.z);
  if (!scale.written || std::max({x, y, z}) <= kRounded * std::min({x, y, z})) return;
  if (std::min({x, y, z}) == 0) return;  // mesh-scale-zero
  context.report({.where = scale.span,
                  .message = fmt::format("the mesh is stretched: its axes are scaled by {}, {} "
                                         "and {}",
                                         scale.value.x, scale.value.y, scale.value.z),
                  .subject = use.subject});
}

Rule rule() {
  return {
      .name = "mesh-scale-nonuniform",
      .severity = Severity::kInfo,
      .summary = "a mesh is scaled by different factors along its axes",
      .why = "Normals have to be turned with it, and not every viewer does: the light looks wrong. "
             "A sphere becomes an ellipsoid, and an inertia of the mesh cannot be scaled by one "
             "number. A slip of one digit in one factor looks just like it.",
      .what_to_do = "Apply the scale to the file and write `1 1 1`.",
      .checks = {on<MeshUse>(check)},
  };
}

}  // namespace rigor::rules::mesh_scale_nonuniform
