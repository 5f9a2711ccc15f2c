// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_scale_zero {

void check(const MeshUse& use, Context& context) {
  const auto& scale = use.mesh.scale;
  const auto [x, y, z] = scale.value;
  if (!scale.written || (x != 0 && y != 0 && z != 0)) return;
  context.report({.where = scale.span,
                  .message = "a scale of zero makes the mesh flat: it has no volume",
                  .subject = use.subject});
}

Rule rule() {
  return {
      .name = "mesh-scale-zero",
      .severity = Severity::kError,
      .summary = "a mesh is scaled by zero",
      .why = "The mesh becomes a plane, a line or a point. It cannot be seen or touched, and "
             "engines that build a hull of it stop.",
      .what_to_do = "Write the factor from the file's unit to metres: 0.001 for millimetres.",
      .checks = {on<MeshUse>(check)},
  };
}

}  // namespace rigor::rules::mesh_scale_zero
