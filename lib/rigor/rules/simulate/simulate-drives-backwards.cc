// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_drives_backwards {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("goes {:.3g} m ahead for each metre that its wheels roll "
                                         "(at least {:.3g} m is expected)",
                                         fact.value, fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-drives-backwards",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the robot does not go ahead when its wheels turn forward",
      .why =
          "An axis points the wrong way, or the inertias are such that the body turns instead"
          " of the wheels.",
      .what_to_do = "Turn the axis round; run `rigor inertia MODEL` when inertias are missing.",
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
      <axis><xyz>0 -1 0</xyz></axis>
    </joint>
    <joint name='right_hinge' type='revolute'>
      <parent>body</parent>
      <child>right</child>
      <axis><xyz>0 -1 0</xyz></axis>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{.text = kCart}},
      .checks = {on_simulation({simulate::FactKind::kDriveBackwards}, check)},
  };
}

}  // namespace rigor::rules::simulate_drives_backwards
