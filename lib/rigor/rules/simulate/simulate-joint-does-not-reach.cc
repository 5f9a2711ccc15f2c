// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_joint_does_not_reach {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("{:.3g} % of its way from limit to limit is out of reach "
                                         "(limit {:.3g} %)",
                                         100 * fact.value, 100 * fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-joint-does-not-reach",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "a joint does not reach its limits",
      .why =
          "Something is in the way: the ground, another link, or the other joints of a closed "
          "loop.",
      .what_to_do = "Clear the way, or set the limit to what the joint can reach.",
      .bad = {{.text = R"(<!-- rigor simulate --test joint-sweep -->
<sdf version='1.9'>
  <model name='press'>
    <link name='foot'>
      <pose>0 0 0.2 0 0 0</pose>
      <inertial>
        <mass>6</mass>
        <inertia><ixx>0.04</ixx><iyy>0.04</iyy><izz>0.04</izz></inertia>
      </inertial>
      <collision name='c'>
        <geometry><box><size>0.1 0.1 0.1</size></box></geometry>
      </collision>
    </link>
    <joint name='«leg»' type='prismatic'>
      <parent>world</parent>
      <child>foot</child>
      <axis><xyz>0 0 1</xyz><limit><lower>-0.3</lower><upper>0.1</upper></limit></axis>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{.text = R"(<sdf version='1.9'>
  <model name='press'>
    <link name='foot'>
      <pose>0 0 0.2 0 0 0</pose>
      <inertial>
        <mass>6</mass>
        <inertia><ixx>0.04</ixx><iyy>0.04</iyy><izz>0.04</izz></inertia>
      </inertial>
      <collision name='c'>
        <geometry><box><size>0.1 0.1 0.1</size></box></geometry>
      </collision>
    </link>
    <joint name='leg' type='prismatic'>
      <parent>world</parent>
      <child>foot</child>
      <axis><xyz>0 0 1</xyz><limit><lower>-0.1</lower><upper>0.1</upper></limit></axis>
    </joint>
  </model>
</sdf>
)"}},
      .checks = {on_simulation({simulate::FactKind::kJointShort}, check)},
  };
}

}  // namespace rigor::rules::simulate_joint_does_not_reach
