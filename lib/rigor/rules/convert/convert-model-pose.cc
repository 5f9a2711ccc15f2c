// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_model_pose {

void check(const convert::Note& note, Context& context) {
  context.report(told(
      note,
      fmt::format("the model's pose ({}) is not in the robot: give it where the robot is spawned",
                  note.written)));
}

Rule rule() {
  return {
      .name = "convert-model-pose",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "where the model stands in the world is not in the robot",
      .why =
          "A model's pose or placement frame places it in a world. URDF describes the robot alone, "
          "from its root link on.",
      .what_to_do =
          "Spawn the robot at that pose, or write it into the file with `--model-pose world-link`.",
      .checks = {on_conversion({convert::NoteKind::kModelPose}, check)},
  };
}

}  // namespace rigor::rules::convert_model_pose
