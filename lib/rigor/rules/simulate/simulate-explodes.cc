// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_explodes {

void check(const simulate::Fact& fact, Context& context) {
  context.report(
      shown(fact, "explodes: it is farther away than a thousand times its size, or nowhere"));
}

Rule rule() {
  return {
      .name = "simulate-explodes",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the simulation explodes",
      .why =
          "A pose stopped being a number, or a body flew farther than a thousand times the "
          "model's size. In a simulator the model vanishes or takes the server with it.",
      .what_to_do =
          "Look at inertias far from those of the links' shapes, at links that overlap where "
          "the model begins, and at masses that differ by a factor of hundreds across a "
          "joint.",
      .checks = {on_simulation({simulate::FactKind::kExplodes}, check)},
  };
}

}  // namespace rigor::rules::simulate_explodes
