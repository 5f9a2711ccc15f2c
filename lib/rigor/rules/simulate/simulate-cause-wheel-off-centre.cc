// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_cause_wheel_off_centre {

void check(const simulate::Fact& fact, Context& context) {
  context.report(
      stated(fact, fmt::format("its wheel is {:.3g} mm off the joint's axis", 1e3 * fact.value),
             "put the wheel's collision on the axis"));
}

Rule rule() {
  return {
      .name = "simulate-cause-wheel-off-centre",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "a wheel's shape is not on its axis",
      .why = "It rolls like an egg: the robot bounces, and its speed varies within each turn.",
      .what_to_do =
          "Move the collision or the joint so that the axis goes through the wheel's middle.",
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
        <pose>0.02 0 0 1.5707963 0 0</pose>
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
    <joint name='«left_hinge»' type='revolute'>
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
      .checks = {on_simulation({simulate::FactKind::kCauseWheelOffCentre}, check)},
  };
}

}  // namespace rigor::rules::simulate_cause_wheel_off_centre
