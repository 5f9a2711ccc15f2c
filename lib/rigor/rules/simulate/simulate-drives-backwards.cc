// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_drives_backwards {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("goes {:.3g} m ahead for each metre that its wheels roll "
                                         "(at least {:.3g} m is expected)",
                                         fact.value, fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-drives-backwards",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the robot does not go ahead when its wheels turn forward",
      .why =
          "An axis points the wrong way, or the inertias are such that the body turns instead"
          " of the wheels.",
      .what_to_do = "Turn the axis round; run `rigor inertia MODEL` when inertias are missing.",
      .checks = {on_simulation({simulate::FactKind::kDriveBackwards}, check)},
  };
}

}  // namespace rigor::rules::simulate_drives_backwards
