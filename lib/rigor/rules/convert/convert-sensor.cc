// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_sensor {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, fmt::format("the sensor {}", whereabouts(note))));
}

Rule rule() {
  return {
      .name = "convert-sensor",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .summary = "a sensor is for Gazebo only",
      .why =
          "URDF has no sensors. A `<gazebo>` block carries the sensor as it is, which Gazebo "
          "reads; all else sees none.",
      .what_to_do = "Nothing for Gazebo; describe it to other tools in their own way.",
      .checks = {on_conversion({convert::NoteKind::kSensor}, check)},
  };
}

}  // namespace rigor::rules::convert_sensor
