// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/sample.h>
#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_stiffness {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, fmt::format("{} is lost: URDF has hard limits only", note.written)));
}

Rule rule() {
  return {
      .name = "convert-stiffness",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "how stiff a joint's stops are is not in the robot",
      .why = "URDF's limits are hard: it has no stiffness and no dissipation of a stop.",
      .what_to_do = "Set them in the simulator where they matter.",
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
    <joint name='elbow' type='revolute'>
      <parent>base</parent>
      <child>tip</child>
      <axis>
        <xyz>0 0 1</xyz>
        <limit>
          <lower>-1</lower>
          <upper>1</upper>
          <effort>5</effort>
          <velocity>2</velocity>
          <«stiffness»>1000</stiffness>
        </limit>
      </axis>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{.text = kSdfArm}},
      .checks = {on_conversion({convert::NoteKind::kStiffness}, check)},
  };
}

}  // namespace rigor::rules::convert_stiffness
