// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_does_not_hold {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("is {:.3g} {} off when it is to hold (limit {:.3g})",
                                         fact.value, position_unit(fact), fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-does-not-hold",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the joints do not hold their position",
      .why =
          "With a controller on each joint the pose is off or swings: the joint begins outside "
          "its limits, something pushes it, or it cannot be controlled at this time step.",
      .what_to_do =
          "Put the start inside the limits, give the links their true inertia, or use a smaller "
          "time step.",
      .checks = {on_simulation({simulate::FactKind::kDoesNotHold}, check)},
  };
}

}  // namespace rigor::rules::simulate_does_not_hold
