// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/read/values.h>
#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::lidar_angle_inverted {

void look_at(xml::Element scan, const model::Sensor& sensor, Context& context) {
  const auto least = read::number_field(read::child_text(scan, "min_angle"), 0);
  const auto most = read::number_field(read::child_text(scan, "max_angle"), 0);
  if (!least.written || !most.written || !(least.value > most.value)) return;
  context.report(
      {.where = least.span,
       .message = fmt::format("the lidar turns from {} rad to {} rad, which is backwards",
                              least.value, most.value),
       .subject = context.subject(sensor),
       .related = {{most.span, "where it ends"}},
       .fix = swap("swap them", least.span, most.span, context)});
}

void check(const model::Sensor& sensor, Context& context) {
  if (!sensor.lidar) return;
  const auto scan = context.element(sensor.lidar->site).child("scan");
  if (!scan) return;
  for (const char* direction : {"horizontal", "vertical"}) {
    if (const auto element = scan->child(direction)) look_at(*element, sensor, context);
  }
}

Rule rule() {
  return {
      .name = "lidar-angle-inverted",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "the least angle of a lidar is above the greatest",
      .why = "libsdformat takes it. The step from one ray to the next is then negative, and the "
             "field of view as well: a scan is drawn mirrored, or nothing is, and what sums up the "
             "steps of a scan message walks the wrong way.",
      .what_to_do = "Write the smaller angle, in radians, as min_angle.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::lidar_angle_inverted
