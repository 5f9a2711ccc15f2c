// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::placement_frame_without_pose {

void check(const model::Include& include, Context& context) {
  if (!include.placement_frame.written || include.placement_frame.value.empty()) return;
  if (!include.pose.site.span.nowhere()) return;
  context.report({.where = include.placement_frame.span,
                  .message = "the placement frame '" + include.placement_frame.value +
                             "' is put nowhere: the include has no <pose>",
                  .fix = fix_of("put it at the origin", Applicability::kUnsafe,
                                inserted(context, include.site, include.placement_frame.span,
                                         "<pose>0 0 0 0 0 0</pose>"))});
}

Rule rule() {
  return {
      .name = "placement-frame-without-pose",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "an include names a placement frame and no pose",
      .why =
          "libsdformat rejects the file: \"<pose> is required when specifying the placement_frame "
          "element\". The pose of the include is where the placement frame is put.",
      .what_to_do = "Write the pose; 0 0 0 0 0 0 puts the frame at the origin.",
      .checks = {on<model::Include>(check)},
  };
}

}  // namespace rigor::rules::placement_frame_without_pose
