// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_turns_off {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("turns {:.3g} % more or less than its wheels allow "
                                         "(limit {:.3g} %)",
                                         100 * fact.value, 100 * fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-turns-off",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the robot does not turn as its wheels do",
      .why =
          "The turn is outside what the track, plus or minus the width of the wheels, allows:"
          " a caster drags, or wheels slip sideways.",
      .what_to_do = "Give casters no friction (mu and mu2 of 0), and check the wheels' positions.",
      .checks = {on_simulation({simulate::FactKind::kTurnOff}, check)},
  };
}

}  // namespace rigor::rules::simulate_turns_off
