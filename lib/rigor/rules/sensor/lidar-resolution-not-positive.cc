// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::lidar_resolution_not_positive {

void check(const model::Sensor& sensor, Context& context) {
  if (!sensor.lidar) return;
  const auto& resolution = sensor.lidar->horizontal.resolution;
  if (!resolution.written || resolution.value > 0) return;
  context.report(
      {.where = resolution.span,
       .message = fmt::format("the lidar reports {} measurements for each ray", resolution.value),
       .subject = context.subject(sensor),
       .fix = Fix{"one for each", Applicability::kUnsafe, {{resolution.span, "1"}}}});
}

Rule rule() {
  return {
      .name = "lidar-resolution-not-positive",
      .severity = Severity::kError,
      .fix = FixGrade::kUnsafe,
      .summary = "a lidar reports no measurement for any of its rays",
      .why = "The resolution of a scan is how many measurements are reported for each ray, 1 in "
             "most files; it is no angle and no distance. The number of measurements is the "
             "samples times the resolution: with 0 there is none, whatever the samples are.",
      .what_to_do = "Write 1, or leave the element out.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::lidar_resolution_not_positive
