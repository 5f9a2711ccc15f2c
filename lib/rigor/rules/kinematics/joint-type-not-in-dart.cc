// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::joint_type_not_in_dart {

void check(const model::Joint& joint, Context& context) {
  if (joint.type != model::JointType::kRevolute2 && joint.type != model::JointType::kGearbox)
    return;
  context.report(
      {.where = joint.type_name.span,
       .message = "gz-sim fixes a " + joint.type_name.value + " joint: its physics, DART, has none",
       .subject = context.subject(joint)});
}

Rule rule() {
  return {
      .name = "joint-type-not-in-dart",
      .severity = Severity::kError,
      .formats = Formats::kSdf,
      .targets = {Target::kGzSim},
      .summary = "a joint has a type that gz-sim makes a fixed one of",
      .why = "gz-sim's usual physics engine is DART, by gz-physics, which has no revolute2 and no "
             "gearbox joint: it says so in its log and creates a fixed joint instead. The wheel "
             "does not turn.",
      .what_to_do = "Write a revolute2 joint as two revolute joints with a small link between "
                    "them, or as a universal joint where both axes meet at right angles; in place "
                    "of a gearbox let one joint <mimic> the other.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::joint_type_not_in_dart
