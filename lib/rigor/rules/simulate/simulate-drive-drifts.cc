// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_drive_drifts {

void check(const simulate::Fact& fact, Context& context) {
  context.report(
      shown(fact, fact.name == "drive.yaw"
                      ? fmt::format("turns by {:.3g}° as it drives straight on (limit {:.3g}°)",
                                    fact.value * kDegrees, fact.limit * kDegrees)
                      : fmt::format("drifts to the side by {:.3g} % of the way (limit {:.3g} %)",
                                    100 * fact.value, 100 * fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-drive-drifts",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the robot does not drive straight",
      .why =
          "Both sides were commanded alike. Radii, friction, masses or axes differ between "
          "left and right.",
      .what_to_do = "Compare the two sides: radius, axis, position of the wheels, masses.",
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
        <pose>0 0 0 1.5707963 0 0</pose>
        <geometry><cylinder><radius>0.1</radius><length>0.03</length></cylinder></geometry>
      </collision>
    </link>
    <link name='right'>
      <pose>0.05 -0.13 0.08 0 0 0</pose>
      <inertial auto='true'/>
      <collision name='tyre'>
        <pose>0 0 0 1.5707963 0 0</pose>
        <geometry><cylinder><radius>0.08</radius><length>0.03</length></cylinder></geometry>
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
      .checks = {on_simulation({simulate::FactKind::kDriveDrifts}, check)},
  };
}

}  // namespace rigor::rules::simulate_drive_drifts
