// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/sample.h>
#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_static {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("static {}", note.instead.empty() ? whereabouts(note)
                                                               : "becomes " + note.instead)));
}

Rule rule() {
  return {
      .name = "convert-static",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .summary = "a static model is fixed to the world",
      .why =
          "URDF has no word for a model that never moves. A fixed joint to a link named world says "
          "the same.",
      .what_to_do = "Nothing: the robot is the same.",
      .bad = {{.text = R"(<sdf version='1.9'>
  <model name='arm'>
    <link name='base'>
      <inertial>
        <mass>2</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
    </link>
    <static>«true»</static>
  </model>
</sdf>
)"}},
      .good = {{.text = kSdfLink}},
      .checks = {on_conversion({convert::NoteKind::kStatic}, check)},
  };
}

}  // namespace rigor::rules::convert_static
