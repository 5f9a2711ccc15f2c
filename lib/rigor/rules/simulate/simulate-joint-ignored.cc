// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_joint_ignored {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("the joint is not simulated{}{}",
                                         fact.name.empty() ? "" : ": ", fact.name)));
}

Rule rule() {
  return {
      .name = "simulate-joint-ignored",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "a joint is not simulated",
      .why =
          "Its type is not known to the engine, or it does not connect two bodies: they move "
          "as if it were not there.",
      .what_to_do =
          "Give the joint a type and two links; `rigor validate` says what is wrong with it.",
      .checks = {on_simulation({simulate::FactKind::kJointIgnored}, check)},
  };
}

}  // namespace rigor::rules::simulate_joint_ignored
