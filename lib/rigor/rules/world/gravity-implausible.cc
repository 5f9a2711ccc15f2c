// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <optional>

#include <fmt/core.h>

#include <rigor/rules/rule.h>

namespace rigor::rules::gravity_implausible {

using model::Vector3;

// m/s². Jupiter has 24.8, and no body with a ground more.
constexpr double kStrongest = 30;

// m/s²: what is written for the Earth.
constexpr double kEarthMin = 9;
constexpr double kEarthMax = 11;

/// Where centimeters or millimeters were written: the number in meters.
std::optional<Fix> in_meters(const model::Field<Vector3>& gravity, double size) {
  for (const double unit : {100.0, 1000.0}) {
    if (size / unit < kEarthMin || size / unit > kEarthMax) continue;
    const Vector3 g = (1 / unit) * gravity.value;
    return Fix{"write it in m/s²",
               Applicability::kUnsafe,
               {{gravity.span, fmt::format("{:.6g} {:.6g} {:.6g}", g.x, g.y, g.z)}}};
  }
  return std::nullopt;
}

void check(const model::World& world, Context& context) {
  const Vector3& g = world.gravity.value;
  if (!world.gravity.written || g.z > 0) return;  // gravity-upward reports that
  const double size = length(g);
  if (size > kStrongest) {
    context.report({.where = world.gravity.span,
                    .message = fmt::format("gravity is {:.4g} m/s²: the Earth's is 9.8", size),
                    .subject = context.subject(world),
                    .fix = in_meters(world.gravity, size)});
    return;
  }
  const double sideways = std::hypot(g.x, g.y);
  if (g.z == 0 && sideways > kEarthMin && sideways < kEarthMax) {
    context.report({.where = world.gravity.span,
                    .message = "gravity pulls sideways: z is zero",
                    .subject = context.subject(world),
                    .help = "the z axis of a world points up, so gravity is 0 0 -9.8"});
  }
}

Rule rule() {
  return {
      .name = "gravity-implausible",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "the world's gravity is stronger than on any planet, or pulls sideways",
      .why = "With gravity in cm/s² or mm/s² all that moves is pressed into the ground; along -y, "
             "as where y is up, all slides off sideways. Gravity is in m/s², and the world's z "
             "axis points up.",
      .what_to_do =
          "Write 0 0 -9.8, or what the place has: 0 0 -1.62 for the Moon, 0 0 0 for none.",
      .checks = {on<model::World>(check)},
  };
}

}  // namespace rigor::rules::gravity_implausible
