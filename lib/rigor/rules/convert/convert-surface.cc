// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_surface {

void check(const convert::Note& note, Context& context) {
  context.report(told(
      note, fmt::format("{} {}", note.written, note.instead.empty() ? "is lost" : note.instead)));
}

Rule rule() {
  return {
      .name = "convert-surface",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .summary = "contact properties are not all in the robot",
      .why =
          "URDF has no friction and no contact. A `<gazebo>` block holds one set for a whole link, "
          "so what differs between its collisions, and what the block has no key for, is lost.",
      .what_to_do = "Give all collisions of a link one surface, or set it in the simulator.",
      .checks = {on_conversion({convert::NoteKind::kSurface}, check)},
  };
}

}  // namespace rigor::rules::convert_surface
