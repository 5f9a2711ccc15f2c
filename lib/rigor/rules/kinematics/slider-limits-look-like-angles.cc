// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include <fmt/core.h>

#include <rigor/rules/rule.h>

namespace rigor::rules::slider_limits_look_like_angles {

constexpr double kDegree = 57.29577951308232;

// rad or m; below that many lengths are near a whole number of degrees.
constexpr double kMin = 0.5;
constexpr double kMax = 6.3;

// Degrees; what is left of π when it was written with four digits.
constexpr double kOff = 0.012;

/// The whole number of degrees that the limit is, zero when it is none.
double whole_degrees(double limit) {
  const double degrees = limit * kDegree;
  return std::abs(degrees - std::round(degrees)) < kOff ? std::round(degrees) : 0;
}

bool is_angle(double limit) {
  const double size = std::abs(limit);
  return size > kMin && size < kMax && whole_degrees(limit) != 0;
}

void check(const model::Joint& joint, Context& context) {
  if (joint.type != model::JointType::kPrismatic || joint.axes.empty()) return;
  const model::Axis& axis = joint.axes.front();
  if (!axis.lower.written || !axis.upper.written) return;
  const bool symmetric = axis.lower.value == -axis.upper.value;
  const bool both = is_angle(axis.lower.value) && is_angle(axis.upper.value) && !symmetric;
  double other = 0;
  if (axis.lower.value == 0 || symmetric) other = axis.upper.value;
  if (axis.upper.value == 0) other = axis.lower.value;
  // One number by itself may be a length; a multiple of five degrees hardly is.
  const bool one = is_angle(other) && std::fmod(whole_degrees(other), 5) == 0;
  if (!both && !one) return;
  context.report(
      {.where = joint.type_name.span,
       .message =
           fmt::format("the prismatic joint slides from {:.4g} m to {:.4g} m, which as angles are "
                       "{:.0f}° and {:.0f}°",
                       axis.lower.value, axis.upper.value, axis.lower.value * kDegree,
                       axis.upper.value * kDegree),
       .subject = context.subject(joint),
       .related = {{axis.lower.span, "the lower limit"}, {axis.upper.span, "the upper limit"}},
       .help = "did you mean 'revolute'?",
       .fix =
           Fix{"make it revolute", Applicability::kUnsafe, {{joint.type_name.span, "revolute"}}}});
}

Rule rule() {
  return {
      .name = "slider-limits-look-like-angles",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a prismatic joint has limits that are angles",
      .why = "The link slides by meters where it should rotate: the type was copied from another "
             "joint, or chosen wrongly in a list. Limits of a prismatic joint are in meters, and "
             "these are whole degrees in radians.",
      .what_to_do = "Make the joint revolute, or write its travel in meters.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::slider_limits_look_like_angles
