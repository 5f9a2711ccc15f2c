// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_cause_caster_friction {

void check(const simulate::Fact& fact, Context& context) {
  context.report(stated(
      fact, fmt::format("it is dragged over the ground with a friction of {:.3g}", fact.value),
      "set its mu and mu2 to 0"));
}

Rule rule() {
  return {
      .name = "simulate-cause-caster-friction",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "a caster that cannot turn has friction",
      .why = "A sphere that stands for a caster is dragged along: the robot cannot turn.",
      .what_to_do = "Set mu and mu2 of the caster's surface to 0.",
      .bad = {{.text = R"(<!-- rigor simulate --test turn -->
<sdf version='1.11'>
  <model name='cart'>
    <link name='body'>
      <pose>0 0 0.1 0 0 0</pose>
      <inertial auto='true'/>
      <collision name='box'>
        <geometry><box><size>0.3 0.2 0.05</size></box></geometry>
      </collision>
      <collision name='caster'>
        <pose>-0.1 0 -0.05 0 0 0</pose>
        <geometry><«sphere»><radius>0.05</radius></sphere></geometry>
      </collision>
    </link>
    <link name='left'>
      <pose>0.05 0.13 0.1 0 0 0</pose>
      <inertial auto='true'/>
      <collision name='tyre'>
        <pose>0 0 0 1.5707963 0 0</pose>
        <geometry><cylinder><radius>0.1</radius><length>0.03</length></cylinder></geometry>
      </collision>
    </link>
    <link name='right'>
      <pose>0.05 -0.13 0.1 0 0 0</pose>
      <inertial auto='true'/>
      <collision name='tyre'>
        <pose>0 0 0 1.5707963 0 0</pose>
        <geometry><cylinder><radius>0.1</radius><length>0.03</length></cylinder></geometry>
      </collision>
    </link>
    <joint name='left_hinge' type='revolute'>
      <parent>body</parent>
      <child>left</child>
      <axis><xyz>0 1 0</xyz></axis>
    </joint>
    <joint name='right_hinge' type='revolute'>
      <parent>body</parent>
      <child>right</child>
      <axis><xyz>0 1 0</xyz></axis>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{.text = kCart}},
      .checks = {on_simulation({simulate::FactKind::kCauseCasterFriction}, check)},
  };
}

}  // namespace rigor::rules::simulate_cause_caster_friction
