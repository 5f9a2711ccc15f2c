// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_tips {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("tips over: its base leans by {:.3g}° (limit {:.3g}°)",
                                         fact.value * kDegrees, fact.limit * kDegrees)));
}

Rule rule() {
  return {
      .name = "simulate-tips",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the model tips over",
      .why = "Its base leans far from how it began: it fell over, or something threw it over.",
      .what_to_do =
          "Bring the centre of mass over what the model stands on: lower or move masses, "
          "widen the stance, add the caster that is missing.",
      .checks = {on_simulation({simulate::FactKind::kTips}, check)},
  };
}

}  // namespace rigor::rules::simulate_tips
