// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_world {

void check(const convert::Note& note, Context& context) {
  context.report(told(
      note,
      fmt::format("{} of the world stays behind: a URDF holds the robot alone", note.written)));
}

Rule rule() {
  return {
      .name = "convert-world",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "what a world says beside the model is not in the robot",
      .why =
          "URDF describes one robot and nothing around it: gravity, lights, physics and other "
          "models of the world stay behind.",
      .what_to_do = "Keep the world file, and include the robot from it.",
      .checks = {on_conversion({convert::NoteKind::kWorld}, check)},
  };
}

}  // namespace rigor::rules::convert_world
