// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_limit_violated {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("goes {:.3g} {} beyond its limit (allowed {:.3g})",
                                         fact.value, position_unit(fact), fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-limit-violated",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "a joint goes beyond its limit",
      .why = "The stop gives way, or the joint begins outside its limits and is thrown back.",
      .what_to_do = "Put the start inside the limits; check the load that the stop must bear.",
      .checks = {on_simulation({simulate::FactKind::kLimitViolated}, check)},
  };
}

}  // namespace rigor::rules::simulate_limit_violated
