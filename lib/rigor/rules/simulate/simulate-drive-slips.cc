// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_drive_slips {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(
      fact, fmt::format("goes {:.3g} % short of, or beyond, what its wheels turn (limit {:.3g} %)",
                        100 * fact.value, 100 * fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-drive-slips",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the robot does not go as far as its wheels turn",
      .why =
          "Wheels slip, bounce or drag something along: odometry that is computed from them "
          "is wrong by that much.",
      .what_to_do =
          "Make wheels cylinders or spheres, not meshes; give casters no friction; check that"
          " driven wheels bear weight and have friction.",
      .checks = {on_simulation({simulate::FactKind::kDriveSlips}, check)},
  };
}

}  // namespace rigor::rules::simulate_drive_slips
