// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/convert/sample.h>
#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_calibration {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, std::string("the calibration is lost: SDF has none")));
}

Rule rule() {
  return {
      .name = "convert-calibration",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .formats = Formats::kUrdf,
      .summary = "a joint's calibration is lost",
      .why = "SDF has no reference positions of a joint.",
      .what_to_do = "Give them to the driver.",
      .bad = {{.text = R"(<robot name='arm'>
  <link name='base'>
    <inertial>
      <mass value='1'/>
      <inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/>
    </inertial>
  </link>
  <link name='tip'>
    <inertial>
      <mass value='1'/>
      <inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/>
    </inertial>
  </link>
  <joint name='elbow' type='revolute'>
    <parent link='base'/>
    <child link='tip'/>
    <axis xyz='0 0 1'/>
    <limit lower='-1' upper='1' effort='5' velocity='2'/>
    <«calibration» rising='0.1'/>
  </joint>
</robot>
)"}},
      .good = {{.text = kUrdfLink}},
      .checks = {on_conversion({convert::NoteKind::kCalibration}, check)},
  };
}

}  // namespace rigor::rules::convert_calibration
