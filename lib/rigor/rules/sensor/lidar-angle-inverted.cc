// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/sensor/lidar_scans.h>

namespace rigor::rules::lidar_angle_inverted {

void look_at(const model::LidarScan& scan, const model::Sensor& sensor, Context& context) {
  const auto& least = scan.min_angle;
  const auto& most = scan.max_angle;
  if (!least.written || !most.written || !(least.value > most.value)) return;
  context.report(
      {.where = least.span,
       .message = fmt::format("the scan from {} rad to {} rad is inverted (min_angle > max_angle)",
                              least.value, most.value),
       .subject = context.subject(sensor),
       .related = {{most.span, "where it ends"}},
       .fix = swap("swap them", least.span, most.span, context)});
}

Rule rule() {
  return {
      .name = "lidar-angle-inverted",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "lidar scan is inverted: min_angle is above max_angle",
      .why =
          "libsdformat accepts it, and the step from one ray to the next is then negative, and the "
          "field of view as well: a scan is drawn mirrored, or nothing is, and what sums up the "
          "steps of a scan message walks the wrong way.",
      .what_to_do = "Write the smaller angle, in radians, as min_angle.",
      .checks = {on<model::Sensor>(check_scans<look_at>)},
  };
}

}  // namespace rigor::rules::lidar_angle_inverted
