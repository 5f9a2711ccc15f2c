// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/kinematics/leader.h>
#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::limit_excludes_zero {

void check(const model::Joint& joint, Context& context) {
  if (!is_limited(joint.type)) return;
  for (const model::Axis& axis : joint.axes) {
    const bool above = axis.lower.written && axis.lower.value > 0;
    const bool below = axis.upper.written && axis.upper.value < 0;
    if ((!above && !below) || axis.lower.value >= axis.upper.value) continue;  // reported otherwise
    const model::Field<double>& limit = above ? axis.lower : axis.upper;
    context.report({.where = limit.span,
                    .message = fmt::format(
                        "the {} limit is {:.6g} {}: the joint cannot be at zero, where it begins",
                        above ? "lower" : "upper", limit.value, position_unit(joint.type)),
                    .subject = context.subject(joint)});
  }
}

Rule rule() {
  return {
      .name = "limit-excludes-zero",
      .severity = Severity::kInfo,
      .summary = "the zero position of a joint is outside its limits",
      .why = "A simulator begins with the joint beyond its stop and pushes it back; MoveIt does "
             "not plan from there, since the state is out of bounds; joint_state_publisher begins "
             "in the middle of the limits. Simulators, RViz and the inspectors of models begin "
             "with every joint at zero.",
      .what_to_do = "Include zero in the limits, or set an initial position in the simulator and "
                    "the controllers.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::limit_excludes_zero
