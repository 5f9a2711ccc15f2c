// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <optional>
#include <string>

#include <fmt/core.h>

#include <rigor/rules/kinematics/leader.h>
#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>
#include <rigor/write/numbers.h>

namespace rigor::rules::limit_excludes_zero {

// Of the upper limit: a knee that never straightens has a lower limit near zero.
constexpr double kFarFromZero = 0.4;

/// Whether a sign was lost: zero is far outside, and within the limits of the robot's other joints, three
/// at least.
bool has_lost_sign(const model::Joint& joint, const model::Axis& axis, const Context& context) {
  if (!(axis.lower.value > kFarFromZero * axis.upper.value)) return false;
  constexpr std::size_t kFewest = 3;
  std::size_t others = 0;
  for (const model::Joint& other : context.root().joints) {
    if (&other == &joint || other.model != joint.model || !is_limited(other.type)) continue;
    for (const model::Axis& one : other.axes) {
      if (one.lower.value > 0 || one.upper.value < 0) return false;
      others += one.lower.written && one.lower.value < one.upper.value;
    }
  }
  return others >= kFewest;
}

std::optional<Fix> with_sign(const model::Axis& axis) {
  const std::string text = write::joined({-1 * axis.lower.value});
  return Fix{"write " + text, Applicability::kUnsafe, {{axis.lower.span, text}}};
}

void check(const model::Joint& joint, Context& context) {
  if (!is_limited(joint.type)) return;
  for (const model::Axis& axis : joint.axes) {
    const bool above = axis.lower.written && axis.lower.value > 0;
    const bool below = axis.upper.written && axis.upper.value < 0;
    if ((!above && !below) || axis.lower.value >= axis.upper.value) continue;  // reported otherwise
    const model::Field<double>& limit = above ? axis.lower : axis.upper;
    const bool lost = above && has_lost_sign(joint, axis, context);
    context.report({.where = limit.span,
                    .message = fmt::format(
                        "the {} limit is {:.6g} {}: the joint cannot be at zero, where it begins",
                        above ? "lower" : "upper", limit.value, position_unit(joint.type)),
                    .subject = context.subject(joint),
                    .help = lost ? "all other joints of the robot can: was its sign lost?" : "",
                    .fix = lost ? with_sign(axis) : std::nullopt,
                    .severity = lost ? std::optional(Severity::kWarning) : std::nullopt});
  }
}

Rule rule() {
  return {
      .name = "limit-excludes-zero",
      .severity = Severity::kInfo,
      .fix = FixGrade::kUnsafe,
      .summary = "the zero position of a joint is outside its limits",
      .why = "A simulator begins with the joint beyond its stop and pushes it back; MoveIt does "
             "not plan from there, since the state is out of bounds; joint_state_publisher begins "
             "in the middle of the limits. Simulators, RViz and the inspectors of models begin "
             "with every joint at zero. It is a warning where zero is far below the lower limit "
             "and within those of all other joints of the robot: a sign was lost.",
      .what_to_do = "Include zero in the limits, or set an initial position in the simulator and "
                    "the controllers.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::limit_excludes_zero
