// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_never_settles {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("is not at rest before {:.3g} s (limit {:.3g} s)",
                                         fact.value, fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-never-settles",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the model does not come to rest",
      .why =
          "It was only set down. Something keeps moving it: contacts that fight, a joint "
          "without damping, an inertia that is far too small, a wheel that rolls away.",
      .what_to_do =
          "Give joints that swing freely some damping; check inertias with `rigor inertia "
          "MODEL`.",
      .checks = {on_simulation({simulate::FactKind::kNeverSettles}, check)},
  };
}

}  // namespace rigor::rules::simulate_never_settles
