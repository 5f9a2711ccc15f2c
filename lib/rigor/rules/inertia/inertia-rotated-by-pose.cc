// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>

#include <rigor/rules/edits.h>
#include <rigor/rules/inertia/tensor_mistake.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::inertia_rotated_by_pose {

/// Of a URDF, where the rotation is an attribute of its own.
std::optional<Fix> without_rotation(const model::Inertial& inertial, const Context& context) {
  if (!context.is_urdf()) return std::nullopt;
  return fix_of("remove the rotation of the inertial", Applicability::kUnsafe,
                attribute_removed(context, inertial.pose.site, "rpy"));
}

void check(const model::Link& link, Context& context) {
  if (link.inertial.pose.pose.value.rotation == model::Quaternion{}) return;
  if (mistaken_tensor(link, context).mistake != TensorMistake::kTurned) return;
  const model::Inertial& inertial = link.inertial;
  context.report({.where = inertial.pose.site.name,
                  .message = "the inertial's pose rotates the tensor away from the shapes: its "
                             "numbers are what they have along the link's own axes",
                  .subject = context.subject(link),
                  .related = {{inertial.tensor_site.name, "the tensor"}},
                  .fix = without_rotation(inertial, context)});
}

Rule rule() {
  return {
      .name = "inertia-rotated-by-pose",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a tensor along the link's axes is turned by its inertial's rotation",
      .why = "A rotation that was copied there from the visual or collision rotates a tensor that "
             "was right along the link's axes. The tensor is taken along the axes that the "
             "inertial's pose or origin gives.",
      .what_to_do = "Take the rotation out of the inertial, and leave the position.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::inertia_rotated_by_pose
