// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_nearly_tips {

void check(const simulate::Fact& fact, Context& context) {
  const double share = 100 * fact.value;
  context.report(shown(
      fact, share < 0
                ? fmt::format("its centre of mass is outside of what it stands on by {:.3g} % "
                              "of half its width",
                              -share)
                : fmt::format("its centre of mass is inside of what it stands on by only "
                              "{:.3g} % of half its width (limit {:.3g} %)",
                              share, 100 * fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-nearly-tips",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the centre of mass is hardly above what the model stands on",
      .why = "A push, a slope or a brake will tip it over that edge.",
      .what_to_do = "Widen the stance, or move the masses towards its middle.",
      .checks = {on_simulation({simulate::FactKind::kNearlyTips}, check)},
  };
}

}  // namespace rigor::rules::simulate_nearly_tips
