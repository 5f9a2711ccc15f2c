// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_pushed_over {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("a push makes its base lean by {:.3g}° (limit {:.3g}°)",
                                         fact.value * kDegrees, fact.limit * kDegrees)));
}

Rule rule() {
  return {
      .name = "simulate-pushed-over",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "a push tips the model over",
      .why =
          "The push is a fifth of the momentum of falling by its own size: a person who bumps"
          " into it.",
      .what_to_do = "Lower the centre of mass, or widen the stance.",
      .checks = {on_simulation({simulate::FactKind::kPushedOver}, check)},
  };
}

}  // namespace rigor::rules::simulate_pushed_over
