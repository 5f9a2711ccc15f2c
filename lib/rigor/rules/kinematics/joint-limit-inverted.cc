// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <fmt/core.h>

#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/dialects.h>

namespace rigor::rules::joint_limit_inverted {

void check(const model::Joint& joint, Context& context) {
  if (joint.type == model::JointType::kFixed) return;
  for (const model::Axis& axis : joint.axes) {
    // The limits of a continuous joint are not read.
    if (context.is_urdf() && joint.type == model::JointType::kContinuous) continue;
    if (!axis.lower.written || !axis.upper.written) continue;
    if (!(axis.lower.value > axis.upper.value)) continue;  // nan is reported as no number
    const std::string lower(context.bytes(axis.lower.span));
    const std::string upper(context.bytes(axis.upper.span));
    context.report(
        {.where = axis.lower.span,
         .message = fmt::format("the lower limit {0} {2} is above the upper {1} {2}",
                                axis.lower.value, axis.upper.value, position_unit(joint.type)),
         .subject = context.subject(joint),
         .related = {{axis.upper.span, "the upper limit"}},
         .fix = Fix{"swap the limits",
                    Applicability::kUnsafe,
                    {{axis.lower.span, upper}, {axis.upper.span, lower}}},
         .severity = is_for_bullet(context) ? Severity::kInfo : Severity::kError});
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
             "model with Bullet's own elements this is an info.",
      .what_to_do = "Swap the limits.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::joint_limit_inverted
