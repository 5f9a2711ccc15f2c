// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::effort_zero {

void check(const model::Joint& joint, Context& context) {
  if (!has_axis(joint.type)) return;
  for (const model::Axis& axis : joint.axes) {
    if (axis.mimic || effort_limit(context.root(), joint, axis) != 0) continue;
    const bool still = velocity_limit(context.root(), joint, axis) == 0;
    context.report({.where = axis.effort.span,
                    .message = fmt::format(
                        "the effort limit is 0 {}{}: nothing can drive the joint",
                        effort_unit(joint.type), still ? ", and so is that of velocity" : ""),
                    .subject = context.subject(joint)});
  }
}

Rule rule() {
  return {
      .name = "effort-zero",
      .severity = Severity::kWarning,
      .summary = "a joint may not be driven: its effort limit is zero",
      .why = "Simulators that heed the limit let no motor, controller or command move the joint; "
             "MoveIt and ros_control complain or stand still.",
      .what_to_do = "Write the motor's greatest effort. For no limit, leave it out of an SDF; in a "
                    "URDF write a large one.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::effort_zero
