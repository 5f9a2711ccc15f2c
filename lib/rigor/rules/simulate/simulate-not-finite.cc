// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_not_finite {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("{} is not a finite number", fact.name)));
}

Rule rule() {
  return {
      .name = "simulate-not-finite",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "a number is not finite",
      .why =
          "ODE takes a mass or tensor of nan silently, and then every pose it computes is "
          "nan; others end the process at once.",
      .what_to_do = "Write a finite number.",
      .checks = {on_simulation({simulate::FactKind::kNotFinite}, check)},
  };
}

}  // namespace rigor::rules::simulate_not_finite
