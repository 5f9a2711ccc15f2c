// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>

#include <rigor/rules/edits.h>
#include <rigor/rules/frame/written_pose.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::quaternion_in_degrees {

std::optional<Finding> check_pose(const model::PoseField& pose, const Context& context) {
  if (!pose.pose.written || !context.root().own(pose.site)) return std::nullopt;
  const RotationFormat format = rotation_format(pose, context);
  if (!format.quaternion || !format.degrees) return std::nullopt;
  return Finding{.where = format.degrees_span,
                 .message = "a quaternion has no unit: degrees=\"true\" does not apply to it",
                 .fix = fix_of("take it out", Applicability::kSafe,
                               attribute_removed(context, pose.site, "degrees"))};
}

Rule rule() {
  return {
      .name = "quaternion-in-degrees",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .formats = Formats::kSdf,
      .fix = FixGrade::kSafe,
      .summary = "a quaternion pose has degrees=\"true\"",
      .why = "libsdformat rejects the file: degrees=\"true\" does not apply to quaternions. A "
             "quaternion has no unit.",
      .what_to_do = "Take degrees=\"true\" out, or write roll, pitch and yaw.",
      .checks = on_poses<check_pose>(),
  };
}

}  // namespace rigor::rules::quaternion_in_degrees
