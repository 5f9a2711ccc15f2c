// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_spring {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("the joint's spring ({}) {}", note.written, whereabouts(note))));
}

Rule rule() {
  return {
      .name = "convert-spring",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .summary = "a joint's spring is not in the robot",
      .why =
          "URDF has no springs. Gazebo reads them from a `<gazebo>` block; whatever else reads the "
          "file sees a joint that swings freely.",
      .what_to_do = "Give the spring to the simulator or the controller.",
      .checks = {on_conversion({convert::NoteKind::kSpring}, check)},
  };
}

}  // namespace rigor::rules::convert_spring
