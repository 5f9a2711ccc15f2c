// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_limits_crossed {

void check(const simulate::Fact& fact, Context& context) {
  context.report(
      shown(fact, fmt::format("lower ({:.6g}) is above upper ({:.6g})", fact.value, fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-limits-crossed",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "a joint's lower limit is above its upper one",
      .why =
          "ODE keeps crossed limits without a word and lets the joint move freely; others "
          "lock it or refuse the model.",
      .what_to_do = "Swap the two limits.",
      .bad = {{.text = R"(<sdf version='1.9'>
  <model name='crane'>
    <link name='arm'>
      <pose>0 0 1 0 0 0</pose>
      <inertial>
        <pose>0.2 0 0 0 0 0</pose>
        <mass>1</mass>
        <inertia><ixx>0.001</ixx><iyy>0.02</iyy><izz>0.02</izz></inertia>
      </inertial>
    </link>
    <joint name='shoulder' type='revolute'>
      <parent>world</parent>
      <child>arm</child>
      <axis>
        <xyz>0 1 0</xyz>
        <limit><lower>«1»</lower><upper>-1</upper></limit>
      </axis>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{.text = kArm}},
      .checks = {on_simulation({simulate::FactKind::kLimitsCrossed}, check)},
  };
}

}  // namespace rigor::rules::simulate_limits_crossed
