// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_shape_ignored {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, "this collision is not simulated: " + fact.name));
}

Rule rule() {
  return {
      .name = "simulate-shape-ignored",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "a collision shape is not simulated",
      .why =
          "The engine has no such shape, a plane or heightmap is on a link that moves, a "
          "heightmap's picture cannot be used, or one collision has two shapes: what it should "
          "touch goes through it.",
      .what_to_do =
          "Use a box, sphere, cylinder, capsule, mesh or plane; for a heightmap a square PNG of "
          "2^n + 1 pixels along a side.",
      .checks = {on_simulation({simulate::FactKind::kShapeIgnored}, check)},
  };
}

}  // namespace rigor::rules::simulate_shape_ignored
