// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_light {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, fmt::format("the light {}", whereabouts(note))));
}

Rule rule() {
  return {
      .name = "convert-light",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .formats = Formats::kSdf,
      .summary = "a light is for Gazebo only",
      .why =
          "URDF has no lights. A `<gazebo>` block carries the light of a link as it is, which "
          "Gazebo "
          "reads; all else sees none.",
      .what_to_do = "Nothing for Gazebo; put the light into the world of another simulator.",
      .checks = {on_conversion({convert::NoteKind::kLight}, check)},
  };
}

}  // namespace rigor::rules::convert_light
