// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <string>
#include <utility>

#include <fmt/core.h>

#include <rigor/rules/rule.h>

namespace rigor::rules::sensor_angle_looks_like_degrees {

// 1 % over a full turn leaves room for 6.3 and the like.
constexpr double kMax = 1.01 * 2 * std::numbers::pi;

/// Looks at two angles that are of the same unit, and reports one.
void look_at(std::initializer_list<std::pair<const char*, model::Field<double>>> angles,
             const std::string& subject, Context& context) {
  for (const auto& [name, angle] : angles) {
    if (!angle.written || !std::isfinite(angle.value) || std::abs(angle.value) <= kMax) continue;
    context.report({.where = angle.span,
                    .message = fmt::format("<{0}> is {1}, which looks like degrees: it is in "
                                           "radians, and {1}° is {2:.6g} rad",
                                           name, angle.value, angle.value / 180 * std::numbers::pi),
                    .subject = subject});
    return;
  }
}

void check_sensor(const model::Sensor& sensor, Context& context) {
  if (!sensor.lidar) return;
  for (const auto* scan : {&sensor.lidar->horizontal, &sensor.lidar->vertical}) {
    look_at({{"min_angle", scan->min_angle}, {"max_angle", scan->max_angle}},
            context.subject(sensor), context);
  }
}

void check_light(const model::Light& light, Context& context) {
  look_at({{"inner_angle", light.spot_inner_angle}, {"outer_angle", light.spot_outer_angle}},
          context.subject(light), context);
}

Rule rule() {
  return {
      .name = "sensor-angle-looks-like-degrees",
      .severity = Severity::kWarning,
      .summary = "an angle of a lidar or a spot light looks like degrees",
      .why = "Taken as such, 80 is thirteen turns: the lidar looks round more than once, with rays "
             "far apart, and the light is no cone. These angles are in radians.",
      .what_to_do = "Convert the angle to radians: 80° is 1.39626.",
      .checks = {on<model::Sensor>(check_sensor), on<model::Light>(check_light)},
  };
}

}  // namespace rigor::rules::sensor_angle_looks_like_degrees
