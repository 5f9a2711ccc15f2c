// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_drive_drifts {

void check(const simulate::Fact& fact, Context& context) {
  context.report(
      shown(fact, fact.name == "drive.yaw"
                      ? fmt::format("turns by {:.3g}° as it drives straight on (limit {:.3g}°)",
                                    fact.value * kDegrees, fact.limit * kDegrees)
                      : fmt::format("drifts to the side by {:.3g} % of the way (limit {:.3g} %)",
                                    100 * fact.value, 100 * fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-drive-drifts",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the robot does not drive straight",
      .why =
          "Both sides were commanded alike. Radii, friction, masses or axes differ between "
          "left and right.",
      .what_to_do = "Compare the two sides: radius, axis, position of the wheels, masses.",
      .checks = {on_simulation({simulate::FactKind::kDriveDrifts}, check)},
  };
}

}  // namespace rigor::rules::simulate_drive_drifts
