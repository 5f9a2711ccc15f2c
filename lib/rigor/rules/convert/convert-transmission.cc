// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/sample.h>
#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_transmission {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("transmission {} {}", note.written,
                             note.instead.empty() ? "is lost: SDF has none" : note.instead)));
}

Rule rule() {
  return {
      .name = "convert-transmission",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .summary = "a transmission is lost",
      .why =
          "SDF has no transmissions: ros_control reads them from the robot description, which "
          "stays URDF.",
      .what_to_do = "Keep the URDF as the robot description.",
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
  </joint>
  <«transmission» name='t'>
    <type>transmission_interface/SimpleTransmission</type>
    <joint name='elbow'/>
  </transmission>
</robot>
)"}},
      .good = {{.text = kUrdfLink}},
      .checks = {on_conversion({convert::NoteKind::kTransmission}, check)},
  };
}

}  // namespace rigor::rules::convert_transmission
