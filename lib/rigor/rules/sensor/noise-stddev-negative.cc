// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string_view>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::noise_stddev_negative {

void look_at(const model::Field<double>& deviation, const model::Sensor& sensor, Context& context) {
  if (!deviation.written || !(deviation.value < 0)) return;
  const std::string_view bytes = context.bytes(deviation.span);
  const std::size_t minus = bytes.find('-');
  std::optional<Fix> fix;
  if (minus != std::string_view::npos && minus < bytes.find_first_of("0123456789.")) {
    const auto at = deviation.span.begin + static_cast<std::uint32_t>(minus);
    fix = Fix{"remove the minus sign",
              Applicability::kUnsafe,
              {{{deviation.span.source, at, at + 1}, ""}}};
  }
  context.report(
      {.where = deviation.span,
       .message = fmt::format("the standard deviation of the noise is {}", deviation.value),
       .subject = context.subject(sensor),
       .fix = std::move(fix)});
}

void look_into(const std::vector<model::Noise>& noises, const model::Sensor& sensor,
               Context& context) {
  for (const model::Noise& noise : noises) look_at(noise.stddev, sensor, context);
}

/// The schema of SDF has a least value for the noise of all other sensors, but not for an IMU's up to 1.4; in a
/// URDF there is none.
void check(const model::Sensor& sensor, Context& context) {
  for (const model::Camera& camera : sensor.cameras) {
    look_into(camera.noises, sensor, context);
  }
  if (sensor.lidar) look_into(sensor.lidar->noises, sensor, context);
  constexpr int kOfAxes = 5;  // SDF 1.5, since when each axis has its own
  if (context.is_urdf() || context.root().version < kOfAxes) {
    look_into(sensor.angular_velocity_noises, sensor, context);
    look_into(sensor.linear_acceleration_noises, sensor, context);
  }
}

Rule rule() {
  return {
      .name = "noise-stddev-negative",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "the noise of a sensor has a negative standard deviation",
      .why = "A standard deviation is not negative. The normal distributions of the C++ library, "
             "which the simulators draw the noise from, are undefined for one; in practice the "
             "noise is the same as without the minus, but that is not guaranteed.",
      .what_to_do =
          "Write how far measurements stray, in the unit of what is measured: 0 and more.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::noise_stddev_negative
