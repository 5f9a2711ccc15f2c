// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/convert/sample.h>
#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_second_axis {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, std::string("a second axis on a joint of one degree of freedom is left out")));
}

Rule rule() {
  return {
      .name = "convert-second-axis",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "a second axis on a joint that has one",
      .why =
          "A revolute or prismatic joint turns about `<axis>`; SDF readers pass over `<axis2>`, "
          "and so does the conversion.",
      .what_to_do = "Take it away, or make the joint a universal one.",
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
      </axis>
      <«axis2»>
        <xyz>0 1 0</xyz>
      </axis2>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{.text = kSdfArm}},
      .checks = {on_conversion({convert::NoteKind::kSecondAxis}, check)},
  };
}

}  // namespace rigor::rules::convert_second_axis
