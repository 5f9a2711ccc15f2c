// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/edits.h>
#include <rigor/rules/kinematics/leader.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::axis2_without_effect {

void check(const model::Joint& joint, Context& context) {
  if (joint.type == model::JointType::kUnknown || joint.type == model::JointType::kGearbox) return;
  if (degrees_of_freedom(joint.type) == 2) return;
  if (joint.axes.empty()) return;
  const model::Site& axis = joint.axes.back().site;
  if (context.bytes(axis.name) != "axis2") return;
  context.report({.where = axis.name,
                  .message = "a " + std::string(to_string(joint.type)) +
                             " joint has no second axis: this one is ignored",
                  .subject = context.subject(joint),
                  .fix = fix_of("remove it", Applicability::kUnsafe, removed(context, axis))});
}

Rule rule() {
  return {
      .name = "axis2-without-effect",
      .severity = Severity::kInfo,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "a joint with one axis has a second",
      .why = "Only universal, revolute2 and gearbox joints have two axes. Of other types nobody "
             "reads <axis2>, and its limits and damping are not there.",
      .what_to_do = "Take it out, or give the joint the type that was meant.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::axis2_without_effect
