// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/plugin/gazebo_block.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::sensor_name_missing {

void check(const model::Sensor& sensor, Context& context) {
  // In SDF the schema's rules say so; an empty name is what name-empty reports.
  if (!context.is_urdf() || sensor.name.written || !is_in_part(sensor)) return;
  context.report({.where = sensor.site.name,
                  .message = "the sensor has no name",
                  .subject = context.subject(sensor)});
}

Rule rule() {
  return {
      .name = "sensor-name-missing",
      .severity = Severity::kError,
      .refused = {.urdf = Refusal::kAlways},
      .formats = Formats::kUrdf,
      .summary = "a sensor in the <gazebo> of a URDF has no name",
      .why = "libsdformat rejects the whole robot: the name is required (error 4).",
      .what_to_do = "Give it a name that no other sensor of the link has.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::sensor_name_missing
