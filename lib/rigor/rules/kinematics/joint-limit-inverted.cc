// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include <fmt/core.h>

#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/dialects.h>

namespace rigor::rules::joint_limit_inverted {

/// Whether inverted limits are how this model for Bullet says that a joint has none: others are, too, or the
/// numbers are those of the idiom.
bool means_no_limits(const model::Joint& joint, const model::Axis& axis, const Context& context) {
  if (!is_for_bullet(context)) return false;
  const auto is_token = [](double limit) { return limit == 0 || std::abs(limit) == 1; };
  if (is_token(axis.lower.value) && is_token(axis.upper.value)) return true;
  const auto& joints = context.root().joints;
  return std::any_of(joints.begin(), joints.end(), [&joint](const model::Joint& other) {
    return &other != &joint && other.type != model::JointType::kFixed && !other.axes.empty() &&
           other.axes.front().lower.value > other.axes.front().upper.value;
  });
}

/// Exchanged, as a rule. Where that would keep the joint from zero, which all others of the robot reach, the
/// lower one lost its sign.
Fix fix_for(const model::Joint& joint, const model::Axis& axis, const Context& context) {
  const std::string lower(context.bytes(axis.lower.span));
  const std::string upper(context.bytes(axis.upper.span));
  std::size_t others = 0;
  bool reach_zero = true;
  for (const model::Joint& other : context.root().joints) {
    if (&other == &joint || other.type != joint.type || other.axes.empty()) continue;
    const model::Axis& range = other.axes.front();
    if (!range.lower.written || !range.upper.written) continue;
    ++others;
    reach_zero = reach_zero && range.lower.value <= 0 && range.upper.value >= 0;
  }
  constexpr std::size_t kFewest = 3;
  if (axis.upper.value > 0 && others >= kFewest && reach_zero) {
    return {"write the lower limit as -" + lower,
            Applicability::kUnsafe,
            {{axis.lower.span, "-" + lower}}};
  }
  return {"swap the limits",
          Applicability::kUnsafe,
          {{axis.lower.span, upper}, {axis.upper.span, lower}}};
}

void check(const model::Joint& joint, Context& context) {
  if (joint.type == model::JointType::kFixed) return;
  for (const model::Axis& axis : joint.axes) {
    // The limits of a continuous joint are not read.
    if (context.is_urdf() && joint.type == model::JointType::kContinuous) continue;
    if (!axis.lower.written || !axis.upper.written) continue;
    if (!(axis.lower.value > axis.upper.value)) continue;  // nan is reported as no number
    context.report(
        {.where = axis.lower.span,
         .message = fmt::format("the lower limit {0} {2} is above the upper {1} {2}",
                                axis.lower.value, axis.upper.value, position_unit(joint.type)),
         .subject = context.subject(joint),
         .related = {{axis.upper.span, "the upper limit"}},
         .fix = fix_for(joint, axis, context),
         .severity = means_no_limits(joint, axis, context) ? Severity::kInfo : Severity::kError});
  }
}

Rule rule() {
  return {
      .name = "joint-limit-inverted",
      .severity = Severity::kError,
      .fix = FixGrade::kUnsafe,
      .summary = "a lower joint limit is above the upper one",
      .why = "No position is within the limits: DART stops at an assertion, Gazebo swaps the "
             "limits of a URDF, and other consumers lock the joint. The checkers (ign sdf -k, gz "
             "sdf -k, check_urdf) do not compare them. Bullet reads inverted limits as none: in a "
             "model with Bullet's own elements that has several such, or 0, 1 and -1 as limits, "
             "this is an info.",
      .what_to_do = "Swap the limits.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::joint_limit_inverted
