// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/rules/sdformat_robot.h>

namespace rigor::rules::joint_type_not_in_sdf {

void check(const model::Model& /*robot*/, Context& context) {
  for (const SdformatRobot::Part& part : context.sdformat_robot().parts) {
    if (part.fate != SdformatRobot::Fate::kLink || !part.joint) continue;
    const model::Joint& joint = context.root()[part.joint];
    if (joint.type != model::JointType::kFloating && joint.type != model::JointType::kPlanar) {
      continue;
    }
    context.report({.where = joint.type_name.span,
                    .message = "SDF has no " + joint.type_name.value + " joint",
                    .subject = context.subject(joint)});
  }
}

Rule rule() {
  return {
      .name = "joint-type-not-in-sdf",
      .severity = Severity::kError,
      .refused = {.urdf = Refusal::kAlways},
      .formats = Formats::kUrdf,
      .targets = {Target::kGazeboClassic, Target::kGzSim},
      .summary = "a joint of a URDF has a type that SDF does not have",
      .why = "libsdformat, through which Gazebo reads URDF, leaves planar and floating joints out. "
             "Version 12 keeps the pose of the child relative to the joint and so refuses what it "
             "made itself (error 25).",
      .what_to_do = "For a planar joint take two prismatic ones and a revolute one. What floats is "
                    "a model of its own.",
      .checks = {on<model::Model>(check)},
  };
}

}  // namespace rigor::rules::joint_type_not_in_sdf
