// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_does_not_brake {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("has {:.3g} % of its speed a second after its wheels "
                                         "stopped (limit {:.3g} %)",
                                         100 * fact.value, 100 * fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-does-not-brake",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the robot does not stop when its wheels do",
      .why = "It slides or tips over its front wheels.",
      .what_to_do =
          "Check the friction of the wheels, and that the centre of mass is not too high.",
      .checks = {on_simulation({simulate::FactKind::kDoesNotBrake}, check)},
  };
}

}  // namespace rigor::rules::simulate_does_not_brake
