// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/convert/sample.h>
#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_light {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, std::string("the light is lost: URDF has none")));
}

Rule rule() {
  return {
      .name = "convert-light",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "a light on a link is lost",
      .why = "URDF has no lights, and Gazebo's blocks carry none.",
      .what_to_do = "Put the light into the world.",
      .bad = {{.text = R"(<sdf version='1.9'>
  <model name='arm'>
    <link name='base'>
      <inertial>
        <mass>2</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
      <«light» name='lamp' type='point'>
        <diffuse>1 1 1 1</diffuse>
      </light>
    </link>
  </model>
</sdf>
)"}},
      .good = {{.text = kSdfLink}},
      .checks = {on_conversion({convert::NoteKind::kLight}, check)},
  };
}

}  // namespace rigor::rules::convert_light
