// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_no_mass {

void check(const simulate::Fact& fact, Context& context) {
  if (fact.name == "all") {
    context.report(shown(fact, "no link has mass: there is nothing to simulate"));
    return;
  }
  context.report(shown(
      fact,
      fmt::format("the mass of a link that moves is {:.6g} kg, and must be above 0", fact.value)));
}

Rule rule() {
  return {
      .name = "simulate-no-mass",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "a body that moves has no mass",
      .why =
          "An engine divides by the mass. ODE ends the process on a mass of zero or less; "
          "Gazebo throws; a URDF link without an inertial is left out by Gazebo together with"
          " what hangs on it.",
      .what_to_do =
          "Give the link a mass: `rigor inertia MODEL --write` computes it from the link's "
          "shapes.",
      .checks = {on_simulation({simulate::FactKind::kNoMass}, check)},
  };
}

}  // namespace rigor::rules::simulate_no_mass
