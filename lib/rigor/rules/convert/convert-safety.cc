// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/sample.h>
#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_safety {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("the safety controller ({}) is lost: SDF has none", note.written)));
}

Rule rule() {
  return {
      .name = "convert-safety",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .summary = "a safety controller is lost",
      .why =
          "SDF has no soft limits of a joint: what kept the controller from running into the stops "
          "is gone.",
      .what_to_do = "Give the soft limits to the controller.",
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
    <«safety_controller» k_velocity='10'/>
  </joint>
</robot>
)"}},
      .good = {{.text = kUrdfLink}},
      .checks = {on_conversion({convert::NoteKind::kSafety}, check)},
  };
}

}  // namespace rigor::rules::convert_safety
