// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include <fmt/core.h>

#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>
#include <rigor/write/numbers.h>

namespace rigor::rules::axis_not_unit {

// Four digits of 0.7071 are off by this much at most.
constexpr double kRounding = 1e-3;

/// Where the direction can be written without rounding: along one of the frame's axes.
std::optional<Fix> of_length_one(const model::Field<model::Vector3>& axis) {
  const model::Vector3& v = axis.value;
  const double length = std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
  const bool along_one = model::length(v) == length && std::isfinite(length);
  if (!along_one) return std::nullopt;
  const auto sign = [](double x) { return x > 0 ? 1.0 : x < 0 ? -1.0 : 0.0; };
  return Fix{"write it with length 1",
             Applicability::kSafe,
             {{axis.span, write::joined({sign(v.x), sign(v.y), sign(v.z)})}}};
}

void check(const model::Joint& joint, Context& context) {
  if (!has_axis(joint.type)) return;
  for (const model::Axis& axis : joint.axes) {
    const double length = model::length(axis.xyz.value);
    if (!axis.xyz.written || length == 0 || std::abs(length - 1) < kRounding) continue;
    context.report({.where = axis.xyz.span,
                    .message = fmt::format("the axis has length {:.4g}, not 1", length),
                    .subject = context.subject(joint),
                    .fix = of_length_one(axis.xyz)});
  }
}

Rule rule() {
  return {
      .name = "axis-not-unit",
      .severity = Severity::kInfo,
      .fix = FixGrade::kSafe,
      .summary = "a joint axis is not a unit vector",
      .why = "libsdformat makes its length one. Readers of URDF differ: some scale the joint's "
             "speed by the length.",
      .what_to_do = "Divide the axis by its length.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::axis_not_unit
