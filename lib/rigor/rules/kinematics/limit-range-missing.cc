// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/kinematics/leader.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::limit_range_missing {

void check(const model::Joint& joint, Context& context) {
  if (joint.type != model::JointType::kRevolute && joint.type != model::JointType::kPrismatic) {
    return;
  }
  for (const model::Axis& axis : joint.axes) {
    if (!axis.limit_written || axis.lower.written || axis.upper.written) continue;
    if (is_stuck(context.root(), joint, axis)) continue;
    context.report({.where = axis.limit_site.name,
                    .message = fmt::format("neither lower nor upper is written: both are 0, and "
                                           "the {} joint cannot move",
                                           to_string(joint.type)),
                    .subject = context.subject(joint)});
  }
}

Rule rule() {
  return {
      .name = "limit-range-missing",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .summary = "a <limit> of a URDF says neither lower nor upper",
      .why = "Both are 0 then, as the format defaults them: a revolute or prismatic joint is "
             "locked where it is. urdfdom says nothing.",
      .what_to_do =
          "Write lower and upper; a revolute joint that may turn without end is a continuous one.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::limit_range_missing
