// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::lidar_samples_zero {

void check(const model::Sensor& sensor, Context& context) {
  if (!sensor.lidar) return;
  const auto& samples = sensor.lidar->horizontal.samples;
  if (!samples.written || samples.value >= 1) return;
  context.report({.where = samples.span,
                  .message = fmt::format("the lidar sends {} rays", samples.value),
                  .subject = context.subject(sensor),
                  .fix = Fix{"send one", Applicability::kUnsafe, {{samples.span, "1"}}}});
}

Rule rule() {
  return {
      .name = "lidar-samples-zero",
      .severity = Severity::kError,
      .fix = FixGrade::kUnsafe,
      .summary = "a lidar sends no ray",
      .why = "ign sdf -k calls it valid; the sensor then measures nothing, and Gazebo may stop "
             "when it makes it.",
      .what_to_do = "Write the number of rays of one scan, 1 and more.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::lidar_samples_zero
