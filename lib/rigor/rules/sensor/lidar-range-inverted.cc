// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::lidar_range_inverted {

void check(const model::Sensor& sensor, Context& context) {
  if (!sensor.lidar) return;
  const auto& least = sensor.lidar->range_min;
  const auto& most = sensor.lidar->range_max;
  if (!least.written || !most.written || least.value < most.value) return;
  context.report({.where = least.span,
                  .message = fmt::format("the lidar measures from {} m to {} m, which is nothing",
                                         least.value, most.value),
                  .subject = context.subject(sensor),
                  .related = {{most.span, "the greatest distance"}},
                  .fix = least.value > most.value
                             ? std::optional(swap("swap them", least.span, most.span, context))
                             : std::nullopt});
}

Rule rule() {
  return {
      .name = "lidar-range-inverted",
      .severity = Severity::kError,
      .fix = FixGrade::kUnsafe,
      .summary = "the least distance of a lidar is not below the greatest",
      .why =
          "ign sdf -k calls it valid; every ray then returns nothing, or the sensor is not made.",
      .what_to_do = "Write a least distance below the greatest, in metres.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::lidar_range_inverted
