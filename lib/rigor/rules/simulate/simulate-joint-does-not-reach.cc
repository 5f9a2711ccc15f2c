// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_joint_does_not_reach {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("{:.3g} % of its way from limit to limit is out of reach "
                                         "(limit {:.3g} %)",
                                         100 * fact.value, 100 * fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-joint-does-not-reach",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "a joint does not reach its limits",
      .why =
          "Something is in the way: the ground, another link, or the other joints of a closed "
          "loop.",
      .what_to_do = "Clear the way, or set the limit to what the joint can reach.",
      .checks = {on_simulation({simulate::FactKind::kJointShort}, check)},
  };
}

}  // namespace rigor::rules::simulate_joint_does_not_reach
