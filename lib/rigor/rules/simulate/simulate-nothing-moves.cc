// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_nothing_moves {

void check(const simulate::Fact& fact, Context& context) {
  context.report(
      shown(fact, "all links are static or fixed to the world: there is nothing to simulate"));
}

Rule rule() {
  return {
      .name = "simulate-nothing-moves",
      .category = Category::kSimulate,
      .severity = Severity::kInfo,
      .summary = "nothing in the model moves",
      .why =
          "All links are static or fixed to the world, so a simulation shows nothing: "
          "whatever the model's masses and contacts are, they were not looked at.",
      .what_to_do =
          "Simulate a model that moves, or take out `<static>` where it was left by mistake.",
      .checks = {on_simulation({simulate::FactKind::kNothingMoves}, check)},
  };
}

}  // namespace rigor::rules::simulate_nothing_moves
