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
      .summary = "min range of a lidar is negative",
      .why =
          "Rendering uses it as the near plane of a camera, which has to be in front of it; with a "
          "negative one the image is empty, or shows what is behind. No reader reports it.",
      .what_to_do = "Write the distance in meters from which on the lidar sees, at least 0.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::lidar_range_negative
