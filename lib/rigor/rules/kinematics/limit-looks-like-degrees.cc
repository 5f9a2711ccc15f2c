// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <optional>

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

/// Both limits are of the same unit, but one that is an angle already was turned into radians before. A
/// small whole number may be either, and then there is no fix.
std::optional<Fix> in_radians(const model::Axis& axis) {
  Fix fix{"write radians", Applicability::kUnsafe, {}};
  for (const model::Field<double>* limit : {&axis.lower, &axis.upper}) {
    if (!limit->written || !std::isfinite(limit->value)) continue;
    if (std::abs(limit->value) <= kTurn) {
      if (limit->value != 0 && std::fmod(limit->value, 1) == 0) return std::nullopt;
      continue;
    }
    fix.edits.push_back({limit->span, write::joined({limit->value / 360 * kTurn})});
  }
  return fix;
}

void check(const model::Joint& joint, Context& context) {
  if (!turns(joint.type)) return;
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
         .fix = in_radians(axis)});
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
