// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_joint_emulated {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(
      fact, fmt::format("the joint is emulated{}{}", fact.name.empty() ? "" : ": ", fact.name)));
}

Rule rule() {
  return {
      .name = "simulate-joint-emulated",
      .category = Category::kSimulate,
      .severity = Severity::kInfo,
      .summary = "a joint is simulated by means of others",
      .why =
          "The engine lacks the joint's type, so it is made of a free joint and a constraint "
          "between its motions. It is stiff but not perfect.",
      .what_to_do = "Nothing; look at `joint.anchor_error` when the joint bears much.",
      .bad = {{.text = R"(<sdf version='1.9'>
  <model name='crane'>
    <link name='arm'>
      <pose>0 0 1 0 0 0</pose>
      <inertial>
        <pose>0.2 0 0 0 0 0</pose>
        <mass>1</mass>
        <inertia><ixx>0.001</ixx><iyy>0.02</iyy><izz>0.02</izz></inertia>
      </inertial>
    </link>
    <joint name='screw' type='screw'>
      <parent>world</parent>
      <child>arm</child>
      <thread_pitch>«20»</thread_pitch>
      <axis>
        <xyz>0 1 0</xyz>
      </axis>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{.text = kArm}},
      .checks = {on_simulation({simulate::FactKind::kJointEmulated}, check)},
  };
}

}  // namespace rigor::rules::simulate_joint_emulated
