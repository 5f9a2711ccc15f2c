// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/sample.h>
#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_limit_stand_in {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("no limit ({}): {} stands for it", note.written, note.instead)));
}

Rule rule() {
  return {
      .name = "convert-limit-stand-in",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .summary = "a finite number stands for a limit that is none",
      .why =
          "URDF wants both limits of a prismatic or half-limited joint, and urdfdom refuses `inf`. "
          "The number is far beyond what any robot reaches, but planners see a limit.",
      .what_to_do = "Write the limit that the joint really has.",
      .bad = {{.text = R"(<sdf version='1.9'>
  <model name='arm'>
    <link name='base'>
      <inertial>
        <mass>2</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
    </link>
    <link name='tip'>
      <inertial>
        <mass>2</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
    </link>
    <joint name='slide' type='prismatic'>
      <parent>base</parent>
      <child>tip</child>
      <«axis»>
        <xyz>0 0 1</xyz>
        <limit>
          <lower>0</lower>
          <effort>5</effort>
          <velocity>2</velocity>
        </limit>
      </axis>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{.text = kSdfArm}},
      .checks = {on_conversion({convert::NoteKind::kLimitStandIn}, check)},
  };
}

}  // namespace rigor::rules::convert_limit_stand_in
