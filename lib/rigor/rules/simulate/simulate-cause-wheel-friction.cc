// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_cause_wheel_friction {

void check(const simulate::Fact& fact, Context& context) {
  context.report(
      stated(fact, fmt::format("the wheel that drives has a friction of only {:.3g}", fact.value),
             "raise its mu and mu2"));
}

Rule rule() {
  return {
      .name = "simulate-cause-wheel-friction",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "a wheel that drives has no friction",
      .why =
          "What it cannot hold on to it cannot push itself along on: the wheel spins, and the "
          "robot stays or turns to its side.",
      .what_to_do = "Set mu and mu2 of the wheel's surface to that of rubber, about 1.",
      .checks = {on_simulation({simulate::FactKind::kCauseWheelFriction}, check)},
  };
}

}  // namespace rigor::rules::simulate_cause_wheel_friction
