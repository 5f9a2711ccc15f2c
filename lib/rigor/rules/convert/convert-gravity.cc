// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_gravity {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, fmt::format("no gravity: this {}", whereabouts(note))));
}

Rule rule() {
  return {
      .name = "convert-gravity",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .summary = "a link without gravity is so for Gazebo only",
      .why =
          "URDF itself has no word for a link that gravity does not pull; a `<gazebo>` block tells "
          "Gazebo.",
      .what_to_do = "Mind it wherever the robot is simulated otherwise.",
      .checks = {on_conversion({convert::NoteKind::kGravity}, check)},
  };
}

}  // namespace rigor::rules::convert_gravity
