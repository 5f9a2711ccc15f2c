// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_cause_wheel_radii {

void check(const simulate::Fact& fact, Context& context) {
  context.report(
      stated(fact,
             fmt::format("its radius is {:.4g} m, and that of {} on the same axle is {:.4g} m",
                         fact.value, fact.name, fact.limit),
             "make both alike"));
}

Rule rule() {
  return {
      .name = "simulate-cause-wheel-radii",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "two wheels of an axle differ in size",
      .why =
          "Turning alike they roll different ways, so that a robot that is told to go straight on "
          "turns; and it leans to one side.",
      .what_to_do = "Give both wheels one radius.",
      .checks = {on_simulation({simulate::FactKind::kCauseWheelRadii}, check)},
  };
}

}  // namespace rigor::rules::simulate_cause_wheel_radii
