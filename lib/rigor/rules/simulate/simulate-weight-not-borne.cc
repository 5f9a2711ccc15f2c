// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_weight_not_borne {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(
      fact,
      fmt::format("at rest the ground bears {:.4g} % more or less than the weight (limit {:.3g} %)",
                  100 * fact.value, 100 * fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-weight-not-borne",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the ground does not bear the model's weight",
      .why =
          "At rest, what the ground pushes back must be the weight. Here it is not: something of "
          "the model falls, bounces or goes through the ground.",
      .what_to_do =
          "Give each link that should touch the ground a collision, and a joint to each link that "
          "is not to fall.",
      .checks = {on_simulation({simulate::FactKind::kUnbalanced}, check)},
  };
}

}  // namespace rigor::rules::simulate_weight_not_borne
