// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>

#include <fmt/core.h>

#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>
#include <rigor/write/numbers.h>

namespace rigor::rules::limit_looks_like_degrees {

constexpr double kTurn = 6.283185307179586;
constexpr double kMax = 720;  // larger ones represent "no limit"

/// Angles that people limit joints by. Those of a joint that may turn several times (10, 100) are
/// none of them.
bool looks_like_degrees(double angle) {
  const double size = std::abs(angle);
  if (size <= kTurn || size > kMax) return false;
  return std::fmod(size, 15) == 0 || size == 170 || size == 350;
}

/// Bounds of any other number, beyond the turns that a multi-turn joint is given; those are round, or
/// counted in half turns.
bool look_like_degrees(const model::Field<double>& lower, const model::Field<double>& upper) {
  constexpr double kMaxOfTurns = 4 * kTurn;
  constexpr double kCircle = 360;
  const auto is_count = [](double angle) {
    const double half_turns = std::abs(angle) / (kTurn / 2);
    const bool whole = std::fmod(angle, 1) == 0;
    return whole ? std::fmod(angle, 50) == 0 : std::abs(half_turns - std::round(half_turns)) < 0.02;
  };
  if (!lower.written || !upper.written || !(lower.value < upper.value)) return false;
  const double most = std::max(std::abs(lower.value), std::abs(upper.value));
  if (most <= kMaxOfTurns || most > kCircle) return false;
  const double wider = most == std::abs(upper.value) ? upper.value : lower.value;
  return !is_count(wider);
}

std::size_t decimals_of(std::string_view number) {
  const std::size_t point = number.find('.');
  if (point == number.npos) return 0;
  const std::size_t end = number.find_first_not_of("0123456789", point + 1);
  return std::min(end, number.size()) - point - 1;
}

/// The angle in radians with the digits of the author: those of another limit of the robot that is the same to
/// the tenth of a degree that was kept, else as many as the other limits have at most, where that is as exact.
double radians_of(double degrees, const Context& context) {
  constexpr double kSlack = 0.05 / 360 * kTurn;
  const double exact = degrees / 360 * kTurn;
  double decimals = 0;
  for (const model::Joint& joint : context.root().joints) {
    if (!turns(joint.type)) continue;
    for (const model::Axis& axis : joint.axes) {
      for (const model::Field<double>* limit : {&axis.lower, &axis.upper}) {
        if (!limit->written || limit->span.nowhere()) continue;
        if (std::abs(std::abs(limit->value) - std::abs(exact)) < kSlack)
          return std::copysign(limit->value, exact);
        if (std::abs(limit->value) > kTurn) continue;
        const auto count = static_cast<double>(decimals_of(context.bytes(limit->span)));
        decimals = std::max(decimals, count);
      }
    }
  }
  if (decimals == 0) return exact;
  const double power = std::pow(10, decimals);
  const double rounded = std::round(exact * power) / power;
  return std::abs(rounded - exact) < kSlack ? rounded : exact;
}

/// Both limits are of the same unit, but one that is an angle already was turned into radians before. A
/// small whole number may be either, and then there is no fix.
std::optional<Fix> in_radians(const model::Axis& axis, const Context& context) {
  Fix fix{"write radians", Applicability::kUnsafe, {}};
  for (const model::Field<double>* limit : {&axis.lower, &axis.upper}) {
    if (!limit->written || !std::isfinite(limit->value)) continue;
    if (std::abs(limit->value) <= kTurn) {
      if (limit->value != 0 && std::fmod(limit->value, 1) == 0) return std::nullopt;
      continue;
    }
    fix.edits.push_back({limit->span, write::joined({radians_of(limit->value, context)})});
  }
  return fix;
}

void check(const model::Joint& joint, Context& context) {
  // A screw turns many times.
  if (!turns(joint.type) || joint.type == model::JointType::kScrew) return;
  for (const model::Axis& axis : joint.axes) {
    const bool lower = axis.lower.written && looks_like_degrees(axis.lower.value);
    const bool upper = axis.upper.written && looks_like_degrees(axis.upper.value);
    const bool both = joint.type == model::JointType::kRevolute && !lower && !upper &&
                      look_like_degrees(axis.lower, axis.upper);
    if (!lower && !upper && !both) continue;
    const bool wider = both && std::abs(axis.upper.value) >= std::abs(axis.lower.value);
    const model::Field<double>& limit = upper || wider ? axis.upper : axis.lower;
    context.report(
        {.where = limit.span,
         .message = fmt::format(
             "the limit {0} looks like degrees: limits are in radians, and {0}° is {1:.6g} rad",
             limit.value, limit.value / 360 * kTurn),
         .subject = context.subject(joint),
         .fix = in_radians(axis, context)});
  }
}

Rule rule() {
  return {
      .name = "limit-looks-like-degrees",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a limit of a turning joint looks like degrees",
      .why = "Read as such, 90 is fourteen turns, so the joint is in effect unlimited, and cables "
             "and grippers move where the real ones cannot. Limits are in radians.",
      .what_to_do = "Convert the limits to radians: 90° is 1.5708.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::limit_looks_like_degrees
