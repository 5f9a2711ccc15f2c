// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include <rigor/rules/rule.h>

namespace rigor::rules::noise_too_large {

// Standard deviations that no real sensor of the kind has; data sheets are at least ten times below.
constexpr double kRange = 0.5;          // m
constexpr double kShareOfRange = 0.25;  // of the largest distance

/// What is measured: the largest standard deviation of a sensor that is sold, and a common one.
struct Measured {
  double most = 0;
  std::string_view unit;
  std::string_view common;
};

constexpr Measured kGyroscope{0.1, "rad/s", "0.0002 rad/s is a common IMU's"};  // 6°/s
constexpr Measured kAccelerometer{2, "m/s²", "0.017 m/s² is a common IMU's"};
constexpr Measured kPixel{0.5, "of full scale", "0.007 of full scale is a common camera's"};

void check_noise(const model::Noise& noise, const Measured& measured, const model::Sensor& sensor,
                 Context& context) {
  const auto& [most, unit, common] = measured;
  if (!noise.stddev.written || !(noise.stddev.value > most)) return;
  context.report(
      {.where = noise.stddev.span,
       .message = fmt::format("the noise has a standard deviation of {:.4g} {}: no sensor of type "
                              "'{}' has more than {:.2g}",
                              noise.stddev.value, unit, sensor.type.value, most),
       .subject = context.subject(sensor),
       .help = fmt::format("Write it in the sensor's unit: {}", common)});
}

void check(const model::Sensor& sensor, Context& context) {
  for (const model::Noise& noise : sensor.angular_velocity_noises)
    check_noise(noise, kGyroscope, sensor, context);
  for (const model::Noise& noise : sensor.linear_acceleration_noises)
    check_noise(noise, kAccelerometer, sensor, context);
  for (const model::Camera& camera : sensor.cameras) {
    if (sensor.type.value.find("depth") != std::string::npos ||
        sensor.type.value.starts_with("rgbd"))
      continue;
    for (const model::Noise& noise : camera.noises) check_noise(noise, kPixel, sensor, context);
  }
  if (!sensor.lidar) return;
  const auto& range = sensor.lidar->range_max;
  const double most =
      range.written && range.value > 0 ? std::min(kRange, kShareOfRange * range.value) : kRange;
  for (const model::Noise& noise : sensor.lidar->noises)
    check_noise(noise, {most, "m", "0.01 m is a common lidar's"}, sensor, context);
}

Rule rule() {
  return {
      .name = "noise-too-large",
      .severity = Severity::kWarning,
      .summary = "a sensor's noise is larger than any such sensor's",
      .why = "The measurement is noise: filters diverge, and maps are clouds. The standard "
             "deviation is in the unit of what is measured, rad/s, m/s² or m, and of a camera in "
             "shares of full scale; numbers from a data sheet are in °/s, mg or mm.",
      .what_to_do = "Write it in the sensor's unit.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::noise_too_large
