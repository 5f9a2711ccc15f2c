// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/reference/nearest.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::controlled_joint_missing {

void check(const model::Root& root, Context& context) {
  const auto joints = name_set(root.joints);
  for (const model::ControlledJoint& controlled : root.controlled_joints) {
    const std::string& name = controlled.joint.value;
    if (name.empty() || joints.count(name) != 0) continue;
    const std::string who = controlled.ros2_control ? "ros2_control" : "a transmission";
    context.report(with_nearest(
        {.where = controlled.joint.span,
         .message = who + " drives the joint '" + name + "', which this robot does not have"},
        name, [&] { return names_of(root.joints); }, context));
  }
}

Rule rule() {
  return {
      .name = "controlled-joint-missing",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .fix = FixGrade::kUnsafe,
      .summary = "a transmission or ros2_control names a joint that does not exist",
      .why = "The controller manager finds no such joint when it starts: it drops the interface, "
             "or does not start at all.",
      .what_to_do = "Name a joint of the robot.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::controlled_joint_missing
