// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

#include <rigor/rules/rule.h>

namespace rigor::rules::update_rate_zero {

/// Those that draw a picture for each measurement.
constexpr std::string_view kDrawn[] = {"camera", "depth", "rgbd", "lidar", "ray", "multicamera"};

void check(const model::Sensor& sensor, Context& context) {
  if (!sensor.update_rate.written || sensor.update_rate.value != 0) return;
  const bool drawn = std::any_of(std::begin(kDrawn), std::end(kDrawn), [&](std::string_view part) {
    return sensor.type.value.find(part) != std::string::npos;
  });
  context.report({.where = sensor.update_rate.span,
                  .message = std::string("the update rate is 0: the sensor measures at each step") +
                             (drawn ? ", and each measurement is rendered" : ""),
                  .subject = context.subject(sensor),
                  .severity = drawn ? Severity::kWarning : Severity::kInfo});
}

Rule rule() {
  return {
      .name = "update-rate-zero",
      .severity = Severity::kWarning,
      .summary = "a sensor's update rate is zero",
      .why = "0 means as often as there are steps, a thousand times in a second: a camera or "
             "lidar that is rendered as often makes the simulation many times slower. It does not "
             "turn the sensor off. Of sensors that cost nothing, such as an IMU, it is an info.",
      .what_to_do = "Write the sensor's own rate in Hz. To stop it, write "
                    "<always_on>false</always_on> or take it out.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::update_rate_zero
