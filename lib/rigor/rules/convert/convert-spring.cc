// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/sample.h>
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
        </limit>
        <dynamics>
          <spring_reference>0.1</spring_reference>
          <spring_stiffness>«3»</spring_stiffness>
        </dynamics>
      </axis>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{.text = kSdfArm}},
      .checks = {on_conversion({convert::NoteKind::kSpring}, check)},
  };
}

}  // namespace rigor::rules::convert_spring
