// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_cause_start_outside_limits {

void check(const simulate::Fact& fact, Context& context) {
  context.report(stated(
      fact, fmt::format("begins {:.3g} {} outside its limits", fact.value, position_unit(fact)),
      "shift the limits so that they hold zero"));
}

Rule rule() {
  return {
      .name = "simulate-cause-start-outside-limits",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "a joint begins outside its limits",
      .why =
          "All joints begin at zero; limits that leave zero out throw the joint to the "
          "nearest one in the first step.",
      .what_to_do = "Shift the limits and the joint's pose so that zero lies between them.",
      .checks = {on_simulation({simulate::FactKind::kCauseStartOutsideLimits}, check)},
  };
}

}  // namespace rigor::rules::simulate_cause_start_outside_limits
