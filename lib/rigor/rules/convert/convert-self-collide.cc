// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_self_collide {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, fmt::format("self_collide {}", whereabouts(note))));
}

Rule rule() {
  return {
      .name = "convert-self-collide",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .summary = "self-collision is for Gazebo only",
      .why =
          "URDF itself says nothing of whether links of the robot collide with each other; a "
          "`<gazebo>` block tells Gazebo.",
      .what_to_do = "Tell planners in their own file (SRDF).",
      .checks = {on_conversion({convert::NoteKind::kSelfCollide}, check)},
  };
}

}  // namespace rigor::rules::convert_self_collide
