// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/write/numbers.h>

namespace rigor::rules::gear_ratio_zero {

void check_joint(const model::Joint& joint, Context& context) {
  const bool gearbox = joint.type == model::JointType::kGearbox;
  if (!gearbox && joint.type != model::JointType::kScrew) return;
  const model::Field<double>& ratio = gearbox ? joint.gearbox_ratio : joint.thread_pitch;
  if (!ratio.written || ratio.value != 0) return;
  context.report({.where = ratio.span,
                  .message = gearbox ? "the gear ratio is 0" : "the thread pitch is 0",
                  .subject = context.subject(joint)});
}

void check_reduction(const model::Parameter& holder, Context& context) {
  const auto* reduction = find(holder.children, "mechanicalReduction");
  if (reduction == nullptr || write::number_in(reduction->value.value) != 0.0) return;
  context.report({.where = reduction->value.span, .message = "the reduction of the gear is 0"});
}

void check_transmissions(const model::Root& root, Context& context) {
  for (const model::Parameter& transmission : root.transmissions) {
    if (!root.own(transmission.site)) continue;
    check_reduction(transmission, context);
    for (const model::Parameter& part : transmission.children) {
      if (part.name == "joint" || part.name == "actuator") check_reduction(part, context);
    }
  }
}

Rule rule() {
  return {
      .name = "gear-ratio-zero",
      .severity = Severity::kError,
      .summary = "a gear ratio, reduction or thread pitch is zero",
      .why = "One side would stand still however the other turns, and to compute the one from the "
             "other is a division by zero: ros_control and ros2_control throw \"Transmission "
             "reduction ratio cannot be zero\".",
      .what_to_do = "Write the ratio; 1 where there is no gear.",
      .checks = {on<model::Joint>(check_joint), on<model::Root>(check_transmissions)},
  };
}

}  // namespace rigor::rules::gear_ratio_zero
