// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_joint_pulled_apart {

void check(const simulate::Fact& fact, Context& context) {
  context.report(
      shown(fact, fmt::format("the joint's two sides are {:.3g} mm apart (limit {:.3g} mm)",
                              1e3 * fact.value, 1e3 * fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-joint-pulled-apart",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "a joint is pulled apart",
      .why =
          "The two sides of the joint separate: the load or the ratio of masses is more than "
          "the solver can hold together, or a closed loop does not close.",
      .what_to_do =
          "Keep neighbouring masses within a factor of about 50; check that loops close at "
          "the start; use a smaller time step.",
      .checks = {on_simulation({simulate::FactKind::kAnchorError}, check)},
  };
}

}  // namespace rigor::rules::simulate_joint_pulled_apart
