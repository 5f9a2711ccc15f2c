// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_cause_wheel_axis {

void check(const simulate::Fact& fact, Context& context) {
  context.report(
      stated(fact,
             fact.name == "reversed"
                 ? "its axis points the other way: a positive velocity rolls the wheel backwards"
                 : fmt::format("its axis is {:.3g}° off the wheel's own", fact.value * kDegrees),
             "make the joint's axis that of the wheel"));
}

Rule rule() {
  return {
      .name = "simulate-cause-wheel-axis",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "a wheel's joint axis is not the wheel's own",
      .why = "The wheel wobbles, drags to the side, or turns against the other one.",
      .what_to_do =
          "Make the joint's axis that of the cylinder, and the same way round on both sides.",
      .bad = {{.text = R"(<!-- rigor simulate --test drive -->
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
        <geometry><sphere><radius>0.05</radius></sphere></geometry>
        <surface><friction><ode><mu>0</mu><mu2>0</mu2></ode></friction></surface>
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
    <joint name='«right_hinge»' type='revolute'>
      <parent>body</parent>
      <child>right</child>
      <axis><xyz>0 -1 0</xyz></axis>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{.text = kCart}},
      .checks = {on_simulation({simulate::FactKind::kCauseWheelAxis}, check)},
  };
}

}  // namespace rigor::rules::simulate_cause_wheel_axis
