// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/kinematics/ros_model.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::joint_type_not_in_urdf {

void check(const model::Joint& joint, Context& context) {
  if (!may_be_for_ros(context.root(), joint.model)) return;
  switch (joint.type) {
    case model::JointType::kBall:
    case model::JointType::kUniversal:
    case model::JointType::kRevolute2:
    case model::JointType::kScrew:
    case model::JointType::kGearbox: break;
    default: return;
  }
  context.report({.where = joint.type_name.span,
                  .message = "URDF has no " + joint.type_name.value +
                             " joint, and robot_state_publisher refuses the model",
                  .subject = context.subject(joint)});
}

Rule rule() {
  return {
      .name = "joint-type-not-in-urdf",
      .severity = Severity::kError,
      .formats = Formats::kSdf,
      .targets = {Target::kRos},
      .summary = "a joint has a type that a robot of ROS cannot have",
      .why =
          "ROS reads SDF by sdformat_urdf, which makes a URDF robot of it. It knows fixed, "
          "continuous, revolute and prismatic joints, and refuses the whole model for any other.",
      .what_to_do = "Write a universal joint as two revolute ones, with a small link between them.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::joint_type_not_in_urdf
