// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_falls_through {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, "falls: nothing of it touches the ground"));
}

Rule rule() {
  return {
      .name = "simulate-falls-through",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "nothing holds the model: it falls",
      .why = "No shape of it touches the ground, so it falls for ever.",
      .what_to_do = "Give the links that should touch the ground a collision.",
      .checks = {on_simulation({simulate::FactKind::kFalls}, check)},
  };
}

}  // namespace rigor::rules::simulate_falls_through
