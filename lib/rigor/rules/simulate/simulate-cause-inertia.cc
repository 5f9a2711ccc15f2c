// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_cause_inertia {

void check(const simulate::Fact& fact, Context& context) {
  context.report(stated(
      fact,
      fact.value >= 1 ? fmt::format("has {:.4g} times the inertia of its shape", fact.value)
                      : fmt::format("has 1/{:.4g} of the inertia of its shape", 1 / fact.value),
      "run `rigor inertia MODEL --write`"));
}

Rule rule() {
  return {
      .name = "simulate-cause-inertia",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "a link's inertia is not that of its shapes",
      .why =
          "A wheel with 200 times its inertia turns the robot instead of itself; one with a "
          "thousandth of it spins up at a touch.",
      .what_to_do = "Run `rigor inertia MODEL --write`.",
      .checks = {on_simulation({simulate::FactKind::kCauseInertia}, check)},
  };
}

}  // namespace rigor::rules::simulate_cause_inertia
