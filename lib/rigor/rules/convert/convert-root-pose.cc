// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_root_pose {

void check(const convert::Note& note, Context& context) {
  context.report(told(
      note, fmt::format("the root link stands at {} in the model; the robot's frame is the link's",
                        note.written)));
}

Rule rule() {
  return {
      .name = "convert-root-pose",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .formats = Formats::kSdf,
      .summary = "the root link is not at the model's origin",
      .why =
          "URDF has no place for the pose of the root link: the robot's frame is the root link's. "
          "All links keep their places relative to each other.",
      .what_to_do = "Move the link to the model's origin when the offset matters.",
      .checks = {on_conversion({convert::NoteKind::kRootPose}, check)},
  };
}

}  // namespace rigor::rules::convert_root_pose
