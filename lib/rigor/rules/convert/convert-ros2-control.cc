// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_ros2_control {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("ros2_control {} {}", note.written,
                             note.instead.empty() ? "is lost: SDF has none" : note.instead)));
}

Rule rule() {
  return {
      .name = "convert-ros2-control",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .summary = "a ros2_control block is lost",
      .why =
          "SDF has no hardware description: ros2_control reads it from the robot description, "
          "which stays URDF.",
      .what_to_do = "Keep the URDF as the robot description.",
      .checks = {on_conversion({convert::NoteKind::kRos2Control}, check)},
  };
}

}  // namespace rigor::rules::convert_ros2_control
