// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_cause_wheel_off_centre {

void check(const simulate::Fact& fact, Context& context) {
  context.report(
      stated(fact, fmt::format("its wheel is {:.3g} mm off the joint's axis", 1e3 * fact.value),
             "put the wheel's collision on the axis"));
}

Rule rule() {
  return {
      .name = "simulate-cause-wheel-off-centre",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "a wheel's shape is not on its axis",
      .why = "It rolls like an egg: the robot bounces, and its speed varies within each turn.",
      .what_to_do =
          "Move the collision or the joint so that the axis goes through the wheel's middle.",
      .checks = {on_simulation({simulate::FactKind::kCauseWheelOffCentre}, check)},
  };
}

}  // namespace rigor::rules::simulate_cause_wheel_off_centre
