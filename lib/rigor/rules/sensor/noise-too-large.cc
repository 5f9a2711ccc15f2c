// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include <rigor/rules/rule.h>

namespace rigor::rules::noise_too_large {

// Standard deviations that no real sensor of the kind has; data sheets are at least ten times below.
constexpr double kGyroscope = 0.1;      // rad/s: 6°/s
constexpr double kAccelerometer = 2;    // m/s²
constexpr double kPixel = 0.5;          // of full scale, 1
constexpr double kRange = 0.5;          // m
constexpr double kShareOfRange = 0.25;  // of the largest distance

/// Whether one of the elements around the noise is named so.
bool is_in(xml::Element element, std::string_view name) {
  for (auto around = element.parent(); around; around = around->parent()) {
    if (around->name() == name) return true;
    if (around->name() == "sensor") return false;
  }
  return false;
}

void check_noise(const model::Noise& noise, double most, std::string_view unit,
                 const model::Sensor& sensor, Context& context) {
  if (!noise.stddev.written || !(noise.stddev.value > most)) return;
  context.report(
      {.where = noise.stddev.span,
       .message = fmt::format("the noise has a standard deviation of {:.4g} {}: no sensor of type "
                              "'{}' has more than {:.2g}",
                              noise.stddev.value, unit, sensor.type.value, most),
       .subject = context.subject(sensor)});
}

void check(const model::Sensor& sensor, Context& context) {
  for (const model::Noise& noise : sensor.imu_noises) {
    const xml::Element element = context.element(noise.site);
    const bool rotation = is_in(element, "angular_velocity") || element.name() == "rate";
    check_noise(noise, rotation ? kGyroscope : kAccelerometer, rotation ? "rad/s" : "m/s²", sensor,
                context);
  }
  for (const model::Camera& camera : sensor.cameras) {
    if (sensor.type.value.find("depth") != std::string::npos ||
        sensor.type.value.starts_with("rgbd"))
      continue;
    for (const model::Noise& noise : camera.noises)
      check_noise(noise, kPixel, "of full scale", sensor, context);
  }
  if (!sensor.lidar) return;
  const auto& range = sensor.lidar->range_max;
  const double most =
      range.written && range.value > 0 ? std::min(kRange, kShareOfRange * range.value) : kRange;
  for (const model::Noise& noise : sensor.lidar->noises)
    check_noise(noise, most, "m", sensor, context);
}

Rule rule() {
  return {
      .name = "noise-too-large",
      .severity = Severity::kWarning,
      .summary = "a sensor's noise is larger than any such sensor's",
      .why = "The measurement is noise: filters diverge, and maps are clouds. The standard "
             "deviation is in the unit of what is measured, rad/s, m/s² or m, and of a camera in "
             "shares of full scale; numbers from a data sheet are in °/s, mg or mm.",
      .what_to_do = "Write it in the sensor's unit: 0.0002 rad/s and 0.017 m/s² are a common "
                    "IMU's.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::noise_too_large
