// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/convert/sample.h>
#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_continuous {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, std::string("revolute without limits: continuous in URDF")));
}

Rule rule() {
  return {
      .name = "convert-continuous",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .summary = "a revolute joint without limits is a continuous one",
      .why = "SDF and URDF say the same in other words.",
      .what_to_do = "Nothing: the joint is the same.",
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
    <joint name='elbow' type='«revolute»'>
      <parent>base</parent>
      <child>tip</child>
      <axis>
        <xyz>0 0 1</xyz>
        <limit>
          <effort>5</effort>
          <velocity>2</velocity>
        </limit>
      </axis>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{.text = kSdfArm}},
      .checks = {on_conversion({convert::NoteKind::kContinuous}, check)},
  };
}

}  // namespace rigor::rules::convert_continuous
