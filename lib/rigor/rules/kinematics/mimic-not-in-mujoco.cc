// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::mimic_not_in_mujoco {

void check(const model::Joint& joint, Context& context) {
  for (const model::Axis& axis : joint.axes) {
    if (!axis.mimic) continue;
    context.report({.where = axis.mimic->site.name,
                    .message = "MuJoCo passes over this <mimic>: the joint moves by itself",
                    .subject = context.subject(joint)});
  }
}

Rule rule() {
  return {
      .name = "mimic-not-in-mujoco",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .targets = {Target::kMujoco},
      .summary = "a joint mimics another, which MuJoCo passes over",
      .why = "MuJoCo's reader of URDF does not look at <mimic>. The joint is free, and the finger "
             "of a gripper that should follow hangs loose.",
      .what_to_do = "Save the robot as MJCF and add <equality><joint joint1=\"follower\" "
                    "joint2=\"leader\" polycoef=\"0 1 0 0 0\"/></equality>: the first number is "
                    "the offset, the second the multiplier.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::mimic_not_in_mujoco
