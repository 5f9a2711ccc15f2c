// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_mesh_as_hull {

void check(const simulate::Fact& fact, Context& context) {
  const char* why = fact.name == "convex"      ? "which it nearly is"
                    : fact.name == "too large" ? "since it has too many triangles"
                                               : "as was asked for";
  context.report(shown(fact, fmt::format("the mesh is simulated as its convex hull, {}", why)));
}

Rule rule() {
  return {
      .name = "simulate-mesh-as-hull",
      .category = Category::kSimulate,
      .severity = Severity::kInfo,
      .summary = "a collision mesh is simulated as its convex hull",
      .why =
          "Engines collide convex shapes well and triangles badly, and an open mesh has no "
          "inside. What the hull adds collides too.",
      .what_to_do =
          "Nothing, where the hull is good enough; else `rigor mesh-check FILE --convex-"
          "pieces 16` makes convex pieces of it.",
      .checks = {on_simulation({simulate::FactKind::kMeshAsHull}, check)},
  };
}

}  // namespace rigor::rules::simulate_mesh_as_hull
