// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_self_collides {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(
      fact,
      fmt::format("collides with {} by {:.3g} mm",
                  fact.name.empty() ? "another link of the model" : fact.name, 1e3 * fact.value)));
}

Rule rule() {
  return {
      .name = "simulate-self-collides",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "links of the model collide with each other",
      .why =
          "They should pass each other, or their collision shapes are larger than what is "
          "drawn.",
      .what_to_do = "Make the collisions smaller, or limit the joint to where they do not meet.",
      .checks = {on_simulation({simulate::FactKind::kSelfCollides}, check)},
  };
}

}  // namespace rigor::rules::simulate_self_collides
