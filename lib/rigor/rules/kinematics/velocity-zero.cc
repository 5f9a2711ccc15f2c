// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::velocity_zero {

void check(const model::Joint& joint, Context& context) {
  if (!has_axis(joint.type)) return;
  for (const model::Axis& axis : joint.axes) {
    if (axis.mimic || velocity_limit(context.root(), joint, axis) != 0) continue;
    if (effort_limit(context.root(), joint, axis) == 0) continue;  // effort-zero says both
    context.report({.where = axis.velocity.span,
                    .message = fmt::format("the velocity limit is 0 {}/s: the joint can never move",
                                           position_unit(joint.type)),
                    .subject = context.subject(joint)});
  }
}

Rule rule() {
  return {
      .name = "velocity-zero",
      .severity = Severity::kWarning,
      .summary = "a joint may not move: its velocity limit is zero",
      .why = "DART, the engine of new Gazebo, then holds the joint still; MoveIt cannot time a "
             "trajectory through it.",
      .what_to_do = "Write the joint's greatest speed. For no limit, leave it out of an SDF; in a "
                    "URDF write a large one.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::velocity_zero
