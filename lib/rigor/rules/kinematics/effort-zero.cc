// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <string_view>

#include <fmt/core.h>

#include <rigor/rules/kinematics/driven_joint.h>
#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::effort_zero {

/// A joint that is locked by its range, or passive: a damper or spring moves it, and no motor is meant.
bool needs_no_motor(const model::Axis& axis) {
  const bool locked =
      axis.lower.written && axis.upper.written && axis.lower.value == axis.upper.value;
  return locked || (axis.damping.written && axis.damping.value > 0);
}

/// What is built without a motor.
bool is_caster(std::string_view name) {
  for (const std::string_view word : {"caster", "Caster", "castor", "roller", "Roller", "swivel"}) {
    if (name.find(word) != name.npos) return true;
  }
  return false;
}

void check(const model::Joint& joint, Context& context) {
  if (!has_axis(joint.type)) return;
  for (const model::Axis& axis : joint.axes) {
    if (axis.mimic || effort_limit(context.root(), joint, axis) != 0) continue;
    const bool driven = is_driven(joint, context.root());
    if (!driven && (is_caster(joint.name.value) || is_caster(joint.child.value))) continue;
    const bool still = velocity_limit(context.root(), joint, axis) == 0;
    context.report(
        {.where = axis.effort.span,
         .message =
             fmt::format("the effort limit is 0 {}{}: nothing can drive the joint",
                         effort_unit(joint.type), still ? ", and so is that of velocity" : ""),
         .subject = context.subject(joint),
         .severity = !driven || (still && needs_no_motor(axis)) ? std::optional(Severity::kInfo)
                                                                : std::nullopt});
  }
}

Rule rule() {
  return {
      .name = "effort-zero",
      .severity = Severity::kWarning,
      .summary = "effort limit is zero",
      .why =
          "Simulators that apply the limit let no controller or command move the joint; MoveIt "
          "and ros_control report it or do not move. Where no transmission, command interface or "
          "plugin of the file drives the joint, where its limits lock it, or it has damping and "
          "a velocity of zero as passive ones have, it is an info; casters and rollers that "
          "nothing drives need no motor.",
      .what_to_do = "Write the motor's maximum effort. For no limit, omit it in SDF; in a URDF "
                    "write a large one.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::effort_zero
