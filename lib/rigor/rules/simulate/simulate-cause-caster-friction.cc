// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_cause_caster_friction {

void check(const simulate::Fact& fact, Context& context) {
  context.report(stated(
      fact, fmt::format("it is dragged over the ground with a friction of {:.3g}", fact.value),
      "set its mu and mu2 to 0"));
}

Rule rule() {
  return {
      .name = "simulate-cause-caster-friction",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "a caster that cannot turn has friction",
      .why = "A sphere that stands for a caster is dragged along: the robot cannot turn.",
      .what_to_do = "Set mu and mu2 of the caster's surface to 0.",
      .checks = {on_simulation({simulate::FactKind::kCauseCasterFriction}, check)},
  };
}

}  // namespace rigor::rules::simulate_cause_caster_friction
