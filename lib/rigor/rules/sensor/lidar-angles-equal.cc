// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/sensor/lidar_scans.h>

namespace rigor::rules::lidar_angles_equal {

void look_at(const model::LidarScan& scan, const model::Sensor& sensor, Context& context) {
  if (!scan.min_angle.written || !scan.max_angle.written || !scan.samples.written) return;
  if (!(scan.samples.value > 1) || scan.min_angle.value != scan.max_angle.value) return;
  context.report(
      {.where = scan.min_angle.span,
       .message = fmt::format("all {} rays go one way: min_angle and max_angle are both {} rad",
                              scan.samples.value, scan.min_angle.value),
       .subject = context.subject(sensor),
       .related = {{scan.max_angle.span, "the other"}}});
}

Rule rule() {
  return {
      .name = "lidar-angles-equal",
      .severity = Severity::kWarning,
      .summary = "a lidar of several rays has no field of view",
      .why = "min_angle and max_angle are the same, so that all rays measure one distance; mostly "
             "a minus was lost.",
      .what_to_do = "Write the two ends of the scan, in radians, or one sample.",
      .checks = {on<model::Sensor>(check_scans<look_at>)},
  };
}

}  // namespace rigor::rules::lidar_angles_equal
