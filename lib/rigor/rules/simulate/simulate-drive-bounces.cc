// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_drive_bounces {

void check(const simulate::Fact& fact, Context& context) {
  context.report(
      shown(fact, fmt::format("bounces with {:.3g} mm/s as it drives (limit {:.3g} mm/s)",
                              1e3 * fact.value, 1e3 * fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-drive-bounces",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the robot bounces as it drives",
      .why = "A wheel is not round about its axis: off centre, or a mesh with flat sides.",
      .what_to_do = "Put the wheel's collision on its axis, and make it a cylinder.",
      .checks = {on_simulation({simulate::FactKind::kDriveBounces}, check)},
  };
}

}  // namespace rigor::rules::simulate_drive_bounces
