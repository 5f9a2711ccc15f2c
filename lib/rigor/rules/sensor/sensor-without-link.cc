// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/plugin/gazebo_block.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::sensor_without_link {

void check(const model::Sensor& sensor, Context& context) {
  // A reference to nothing is what gazebo-reference-missing reports.
  if (is_in_part(sensor)) return;
  context.report(
      {.where = sensor.site.name,
       .message = "the sensor '" + sensor.name.value + "' is in a <gazebo> that refers to no link",
       .subject = context.subject(sensor)});
}

Rule rule() {
  return {
      .name = "sensor-without-link",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .summary = "a sensor of a URDF is in no link",
      .why = "libsdformat copies a sensor in one into the model, beside the links, where SDF has "
             "no sensors and simulators ignore them. A <gazebo> without a reference is about the "
             "whole robot.",
      .what_to_do =
          "Give the <gazebo> the link that carries the sensor: <gazebo reference=\"camera_link\">.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::sensor_without_link
