// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/kinematics/leader.h>
#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::limit_inverted_frees_joint {

void check(const model::Joint& joint, Context& context) {
  if (!is_limited(joint.type)) return;
  for (const model::Axis& axis : joint.axes) {
    if (!axis.lower.written || !axis.upper.written) continue;
    if (!(axis.lower.value > axis.upper.value)) continue;
    context.report(
        {.where = axis.upper.span,
         .message = fmt::format("the limits {} to {} {} are inverted: Bullet leaves the "
                                "joint without limits",
                                axis.lower.value, axis.upper.value, position_unit(joint.type)),
         .subject = context.subject(joint)});
  }
}

Rule rule() {
  return {
      .name = "limit-inverted-frees-joint",
      .severity = Severity::kInfo,
      .formats = Formats::kUrdf,
      .targets = {Target::kBullet},
      .summary = "Bullet ignores inverted joint limits",
      .why = "Bullet adds no limit to a joint whose lower limit is above the upper one, and models "
             "written for it use that in place of a continuous joint. Other consumers reject such "
             "limits or lock the joint (joint-limit-inverted).",
      .what_to_do = "Make the joint continuous, which all consumers read alike.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::limit_inverted_frees_joint
