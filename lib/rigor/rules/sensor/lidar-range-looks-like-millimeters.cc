// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/write/numbers.h>

namespace rigor::rules::lidar_range_looks_like_millimeters {

// m; lidars on the ground see 300 m, those for mapping from the air 1000.
constexpr double kFarthest = 1000;

// m; a larger number represents no limit.
constexpr double kNoLimit = 1e6;

void check(const model::Sensor& sensor, Context& context) {
  if (!sensor.lidar) return;
  const auto& most = sensor.lidar->range_max;
  if (!most.written || !(most.value > kFarthest) || most.value >= kNoLimit) return;
  context.report(
      {.where = most.span,
       .message = fmt::format("the lidar's range of {0:.6g} m looks like millimeters", most.value),
       .subject = context.subject(sensor),
       .fix = Fix{"write meters",
                  Applicability::kUnsafe,
                  {{most.span, write::joined({most.value / 1000})}}}});
}

Rule rule() {
  return {
      .name = "lidar-range-looks-like-millimeters",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a lidar's range is more than a kilometer",
      .why = "The lidar sees what the real one does not, and depth in its image loses "
             "resolution with the range. Ranges are in meters; data sheets have them in "
             "millimeters.",
      .what_to_do = "Write the largest distance of the data sheet in meters.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::lidar_range_looks_like_millimeters
