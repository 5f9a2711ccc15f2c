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
                  .message = fmt::format(
                      "the lidar measures from {} m to {} m: the range is inverted (min > max)",
                      least.value, most.value),
                  .subject = context.subject(sensor),
                  .related = {{most.span, "the max range"}},
                  .fix = least.value > most.value
                             ? std::optional(swap("swap them", least.span, most.span, context))
                             : std::nullopt});
}

Rule rule() {
  return {
      .name = "lidar-range-inverted",
      .severity = Severity::kError,
      .fix = FixGrade::kUnsafe,
      .summary = "lidar range is inverted: min is not below max",
      .why = "Every ray returns nothing, or the sensor is not created. The checker (ign sdf -k, gz "
             "sdf -k) does not compare the two.",
      .what_to_do = "Write a min below max, in meters.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::lidar_range_inverted
