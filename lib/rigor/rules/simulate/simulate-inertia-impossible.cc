// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_inertia_impossible {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("no rigid body has this inertia: {:.3g} kg·m² where more "
                                         "than {:.3g} is needed",
                                         fact.value, fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-inertia-impossible",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "no rigid body has the inertia tensor",
      .why =
          "A tensor must be positive definite, and two principal moments must sum up to the "
          "third at least. ODE ends the process on the first, and integrates the second into "
          "motions that gain energy.",
      .what_to_do =
          "Run `rigor inertia MODEL --diff`: it shows the tensor that the link's shapes have.",
      .checks = {on_simulation({simulate::FactKind::kInertiaImpossible}, check)},
  };
}

}  // namespace rigor::rules::simulate_inertia_impossible
