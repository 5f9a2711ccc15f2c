// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_drive_bounces {

void check(const simulate::Fact& fact, Context& context) {
  context.report(
      shown(fact, fmt::format("bounces with {:.3g} mm/s as it drives (limit {:.3g} mm/s)",
                              1e3 * fact.value, 1e3 * fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-drive-bounces",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the robot bounces as it drives",
      .why = "A wheel is not round about its axis: off centre, or a mesh with flat sides.",
      .what_to_do = "Put the wheel's collision on its axis, and make it a cylinder.",
      .bad = {{.text = R"(<!-- rigor simulate --test drive -->
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
        <pose>0.02 0 0 1.5707963 0 0</pose>
        <geometry><cylinder><radius>0.1</radius><length>0.03</length></cylinder></geometry>
      </collision>
    </link>
    <link name='right'>
      <pose>0.05 -0.13 0.1 0 0 0</pose>
      <inertial auto='true'/>
      <collision name='tyre'>
        <pose>0.02 0 0 1.5707963 0 0</pose>
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
      .checks = {on_simulation({simulate::FactKind::kDriveBounces}, check)},
  };
}

}  // namespace rigor::rules::simulate_drive_bounces
