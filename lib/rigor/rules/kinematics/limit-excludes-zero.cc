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
    if ((!above && !below) || axis.lower.value >= axis.upper.value) continue;  // told otherwise
    const model::Field<double>& limit = above ? axis.lower : axis.upper;
    context.report(
        {.where = limit.span,
         .message = fmt::format("the {} limit is {:.6g} {}: the joint cannot be at "
                                "zero, where it begins",
                                above ? "lower" : "upper", limit.value, position_unit(joint.type)),
         .subject = context.subject(joint)});
  }
}

Rule rule() {
  return {
      .name = "limit-excludes-zero",
      .severity = Severity::kInfo,
      .summary = "the zero position of a joint is outside its limits",
      .why = "Simulators, RViz and the inspectors of models begin with every joint at zero. A "
             "simulator then begins with a joint beyond its stop and pushes it back; MoveIt "
             "refuses to plan from there, since the state is out of bounds; joint_state_publisher "
             "begins in the middle of the limits.",
      .what_to_do = "Let zero be a position that the joint can take, or tell whatever starts the "
                    "robot where to start it.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::limit_excludes_zero
