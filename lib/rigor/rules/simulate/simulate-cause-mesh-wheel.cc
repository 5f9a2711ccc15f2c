// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_cause_mesh_wheel {

void check(const simulate::Fact& fact, Context& context) {
  context.report(stated(fact, "the wheel collides as a mesh with flat sides",
                        "make its collision a cylinder"));
}

Rule rule() {
  return {
      .name = "simulate-cause-mesh-wheel",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "a wheel collides as a mesh",
      .why =
          "A wheel of flat sides bounces and slips: 3 % of the way with 32 sides, 16 % with "
          "16.",
      .what_to_do =
          "Make its collision a cylinder: `rigor mesh-check FILE --fit cylinder` gives its "
          "size.",
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
        <geometry><«mesh»><uri>wheel.obj</uri></mesh></geometry>
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
=== wheel.obj
v 0.1 0 -0.015
v 0.07071 0.07071 -0.015
v 6.123e-18 0.1 -0.015
v -0.07071 0.07071 -0.015
v -0.1 1.225e-17 -0.015
v -0.07071 -0.07071 -0.015
v -1.837e-17 -0.1 -0.015
v 0.07071 -0.07071 -0.015
v 0.1 0 0.015
v 0.07071 0.07071 0.015
v 6.123e-18 0.1 0.015
v -0.07071 0.07071 0.015
v -0.1 1.225e-17 0.015
v -0.07071 -0.07071 0.015
v -1.837e-17 -0.1 0.015
v 0.07071 -0.07071 0.015
f 8 7 6 5 4 3 2 1
f 9 10 11 12 13 14 15 16
f 1 2 10 9
f 2 3 11 10
f 3 4 12 11
f 4 5 13 12
f 5 6 14 13
f 6 7 15 14
f 7 8 16 15
f 8 1 9 16
)"}},
      .good = {{.text = kCart}},
      .checks = {on_simulation({simulate::FactKind::kCauseMeshWheel}, check)},
  };
}

}  // namespace rigor::rules::simulate_cause_mesh_wheel
