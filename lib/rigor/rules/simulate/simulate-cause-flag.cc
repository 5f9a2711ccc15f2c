// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_cause_flag {

void check(const simulate::Fact& fact, Context& context) {
  context.report(stated(fact,
                        fact.name == "kinematic" ? "is kinematic: no force moves it"
                        : fact.name == "max_contacts"
                            ? "has a max_contacts of 0: it touches nothing"
                            : "gravity does not act on it, as it does on other links of the model",
                        "take the flag out"));
}

Rule rule() {
  return {
      .name = "simulate-cause-flag",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "forces or gravity do not act on a link",
      .why =
          "A kinematic link moves as it is told and by nothing else; one without gravity hangs in "
          "the air and puts no weight on the wheels.",
      .what_to_do = "Take out `<kinematic>` and `<gravity>false` where they were left by mistake.",
      .bad = {{.text = R"(<!-- rigor simulate --test drive -->
<sdf version='1.11'>
  <model name='cart'>
    <link name='«body»'>
      <pose>0 0 0.1 0 0 0</pose>
      <kinematic>true</kinematic>
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
    <joint name='right_hinge' type='revolute'>
      <parent>body</parent>
      <child>right</child>
      <axis><xyz>0 1 0</xyz></axis>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{.text = kCart}},
      .checks = {on_simulation({simulate::FactKind::kCauseFlag}, check)},
  };
}

}  // namespace rigor::rules::simulate_cause_flag
