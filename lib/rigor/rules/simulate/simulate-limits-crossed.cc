// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_limits_crossed {

void check(const simulate::Fact& fact, Context& context) {
  context.report(
      shown(fact, fmt::format("lower ({:.6g}) is above upper ({:.6g})", fact.value, fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-limits-crossed",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "a joint's lower limit is above its upper one",
      .why =
          "ODE keeps crossed limits without a word and lets the joint move freely; others "
          "lock it or refuse the model.",
      .what_to_do = "Swap the two limits.",
      .checks = {on_simulation({simulate::FactKind::kLimitsCrossed}, check)},
  };
}

}  // namespace rigor::rules::simulate_limits_crossed
