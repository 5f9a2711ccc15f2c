// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <fmt/core.h>

#include <rigor/rules/kinematics/leader.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::controlled_joint_fixed {

/// Others, such as those that only name the ends of a chain, move nothing.
bool moves_a_joint(const model::ControlledJoint& controlled) {
  const model::Parameters& given = controlled.parameters;
  if (controlled.ros2_control) return find(given, "command_interface") != nullptr;
  bool any = false;
  for (const model::Parameter& parameter : given) {
    if (parameter.name != "hardwareInterface") continue;
    if (parameter.value.value.find("JointInterface") != std::string::npos) return true;
    any = true;
  }
  return !any;
}

void check(const model::Root& root, Context& context) {
  for (const model::ControlledJoint& controlled : root.controlled_joints) {
    if (root.models.empty() || !root.own(controlled.site)) continue;
    const auto id = joint_named(context.frames(), {0}, controlled.joint.value);
    if (!id || root[id].type != model::JointType::kFixed) continue;
    if (!moves_a_joint(controlled)) continue;
    context.report(
        {.where = controlled.joint.span,
         .message = fmt::format("{} drives the joint '{}', which is fixed",
                                controlled.ros2_control ? "ros2_control" : "a transmission",
                                controlled.joint.value),
         .related = {{root[id].type_name.span, "fixed here"}}});
  }
}

Rule rule() {
  return {
      .name = "controlled-joint-fixed",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .summary = "a transmission or ros2_control drives a fixed joint",
      .why = "Gazebo leaves no trace of the fixed joints of a URDF: gazebo_ros_control then ends "
             "with \"This robot has a joint named … which is not in the gazebo model\", and "
             "gz_ros2_control passes over the joint, so its controllers do not start.",
      .what_to_do = "Make the joint one that moves, or take it out of the block.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::controlled_joint_fixed
