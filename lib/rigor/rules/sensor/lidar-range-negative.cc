// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>

namespace rigor::rules::lidar_range_negative {

void check(const model::Sensor& sensor, Context& context) {
  if (!sensor.lidar) return;
  const auto& least = sensor.lidar->range_min;
  if (!least.written || !(least.value < 0)) return;
  context.report({.where = least.span,
                  .message = fmt::format("the lidar measures from {} m on: no distance is negative",
                                         least.value),
                  .subject = context.subject(sensor)});
}

Rule rule() {
  return {
      .name = "lidar-range-negative",
      .severity = Severity::kWarning,
      .summary = "the least distance of a lidar is negative",
      .why = "No reader complains. Rendering takes it for the near plane of a camera, which lies "
             "in front of it; a negative one shows nothing, or what is behind.",
      .what_to_do = "Write the distance in metres from which on the lidar sees, at least 0.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::lidar_range_negative
