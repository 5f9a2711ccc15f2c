// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_does_not_brake {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("has {:.3g} % of its speed a second after its wheels "
                                         "stopped (limit {:.3g} %)",
                                         100 * fact.value, 100 * fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-does-not-brake",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the robot does not stop when its wheels do",
      .why = "It slides or tips over its front wheels.",
      .what_to_do =
          "Check the friction of the wheels, and that the centre of mass is not too high.",
      .bad = {{.text = R"(<!-- rigor simulate --test brake -->
<sdf version='1.11'>
  <model name='«cart»'>
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
        <surface><friction><ode><mu>0.05</mu><mu2>0.05</mu2></ode></friction></surface>
      </collision>
    </link>
    <link name='right'>
      <pose>0.05 -0.13 0.1 0 0 0</pose>
      <inertial auto='true'/>
      <collision name='tyre'>
        <pose>0 0 0 1.5707963 0 0</pose>
        <geometry><cylinder><radius>0.1</radius><length>0.03</length></cylinder></geometry>
        <surface><friction><ode><mu>0.05</mu><mu2>0.05</mu2></ode></friction></surface>
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
      .checks = {on_simulation({simulate::FactKind::kDoesNotBrake}, check)},
  };
}

}  // namespace rigor::rules::simulate_does_not_brake
