// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_cause_wheel_axis {

void check(const simulate::Fact& fact, Context& context) {
  context.report(
      stated(fact,
             fact.name == "reversed"
                 ? "its axis points the other way: a positive velocity rolls the wheel backwards"
                 : fmt::format("its axis is {:.3g}° off the wheel's own", fact.value * kDegrees),
             "make the joint's axis that of the wheel"));
}

Rule rule() {
  return {
      .name = "simulate-cause-wheel-axis",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "a wheel's joint axis is not the wheel's own",
      .why = "The wheel wobbles, drags to the side, or turns against the other one.",
      .what_to_do =
          "Make the joint's axis that of the cylinder, and the same way round on both sides.",
      .checks = {on_simulation({simulate::FactKind::kCauseWheelAxis}, check)},
  };
}

}  // namespace rigor::rules::simulate_cause_wheel_axis
