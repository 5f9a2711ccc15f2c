// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_cause_mass_ratio {

void check(const simulate::Fact& fact, Context& context) {
  context.report(stated(fact,
                        fmt::format("a joint connects it to {}, which is {:.3g} times as heavy",
                                    fact.name, fact.value),
                        "keep neighbouring masses within a factor of about 50"));
}

Rule rule() {
  return {
      .name = "simulate-cause-mass-ratio",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "neighbouring masses are far apart",
      .why =
          "Iterative solvers need about as many iterations as the ratio of masses across a "
          "joint.",
      .what_to_do =
          "Keep the ratio within about 50: make light links heavier or join them to their "
          "neighbours.",
      .checks = {on_simulation({simulate::FactKind::kCauseMassRatio}, check)},
  };
}

}  // namespace rigor::rules::simulate_cause_mass_ratio
