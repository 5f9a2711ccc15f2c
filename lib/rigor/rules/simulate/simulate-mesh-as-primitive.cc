// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_mesh_as_primitive {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(
      fact,
      fmt::format("the mesh is simulated as the {} that it nearly is: it fills {:.3g} % of it",
                  fact.name, 100 * fact.value)));
}

Rule rule() {
  return {
      .name = "simulate-mesh-as-primitive",
      .category = Category::kSimulate,
      .severity = Severity::kInfo,
      .summary = "a collision mesh is simulated as the primitive it imitates",
      .why =
          "A wheel of 32 flat sides bounces and slips where a cylinder rolls: 3 to 16 % of "
          "the way are lost. So a mesh that nearly is a primitive is simulated as one; a "
          "simulator will not do that.",
      .what_to_do =
          "Write the primitive as the collision: `rigor mesh-check FILE --fit best` gives its"
          " size and pose. `--meshes triangles` simulates the mesh as it is.",
      .checks = {on_simulation({simulate::FactKind::kMeshAsPrimitive}, check)},
  };
}

}  // namespace rigor::rules::simulate_mesh_as_primitive
