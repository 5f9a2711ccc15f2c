// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::fixed_joint_with_axis {

void check(const model::Joint& joint, Context& context) {
  if (joint.type != model::JointType::kFixed || joint.axes.empty()) return;
  const model::Axis& axis = joint.axes.front();
  if (axis.site.element == joint.site.element) return;  // only a limit, or the like
  // Exporters of URDF write 0 0 0 there, and mean none; of SDF axis-zero speaks.
  if (axis.xyz.value == model::Vector3{}) return;
  context.report({.where = axis.site.name,
                  .message = "a fixed joint has no axis: this one is ignored",
                  .subject = context.subject(joint),
                  .fix = fix_of("remove it", Applicability::kUnsafe, removed(context, axis.site))});
}

Rule rule() {
  return {
      .name = "fixed-joint-with-axis",
      .severity = Severity::kInfo,
      .fix = FixGrade::kUnsafe,
      .summary = "a fixed joint has an axis",
      .why =
          "libsdformat and urdfdom ignore it. It is harmless, unless the joint was meant to move.",
      .what_to_do = "Take the axis out, or give the joint the type that was meant.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::fixed_joint_with_axis
