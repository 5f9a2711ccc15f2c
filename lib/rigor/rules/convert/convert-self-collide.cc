// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/sample.h>
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
      .bad = {{.text = R"(<sdf version='1.9'>
  <model name='arm'>
    <self_collide>«true»</self_collide>
    <link name='base'>
      <inertial>
        <mass>2</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
    </link>
  </model>
</sdf>
)"}},
      .good = {{.text = kSdfLink}},
      .checks = {on_conversion({convert::NoteKind::kSelfCollide}, check)},
  };
}

}  // namespace rigor::rules::convert_self_collide
