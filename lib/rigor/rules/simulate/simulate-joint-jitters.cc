// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_joint_jitters {

void check(const simulate::Fact& fact, Context& context) {
  context.report(
      shown(fact, fmt::format("the joint jitters with {:.3g} {}/s above 20 Hz (limit {:.3g})",
                              fact.value, position_unit(fact), fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-joint-jitters",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "a joint jitters",
      .why =
          "Its velocity changes faster than any command: a controller or spring that is too "
          "stiff for the inertia and the time step, or collisions that fight.",
      .what_to_do =
          "Give the link its true inertia, lower gains or stiffness, or use a smaller time "
          "step.",
      .checks = {on_simulation({simulate::FactKind::kJointJitters}, check)},
  };
}

}  // namespace rigor::rules::simulate_joint_jitters
