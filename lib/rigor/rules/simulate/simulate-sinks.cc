// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_sinks {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("sinks {:.3g} mm into the ground (limit {:.3g} mm)",
                                         1e3 * fact.value, 1e3 * fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-sinks",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the model sinks into the ground",
      .why = "Its contacts are too soft for its weight, so wheels stick and cannot turn.",
      .what_to_do =
          "Check the mass (kg, not g), and lower the `<cfm>` of the world's `<constraints>`; with "
          "`--profile gazebo` raise the contact's `<kp>`.",
      .checks = {on_simulation({simulate::FactKind::kSinks}, check)},
  };
}

}  // namespace rigor::rules::simulate_sinks
