// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_cause_start_outside_limits {

void check(const simulate::Fact& fact, Context& context) {
  context.report(stated(
      fact, fmt::format("begins {:.3g} {} outside its limits", fact.value, position_unit(fact)),
      "shift the limits so that they hold zero"));
}

Rule rule() {
  return {
      .name = "simulate-cause-start-outside-limits",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "a joint begins outside its limits",
      .why =
          "All joints begin at zero; limits that leave zero out throw the joint to the "
          "nearest one in the first step.",
      .what_to_do = "Shift the limits and the joint's pose so that zero lies between them.",
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
        <«limit»><lower>0.5</lower><upper>1</upper></limit>
      </axis>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{.text = kArm}},
      .checks = {on_simulation({simulate::FactKind::kCauseStartOutsideLimits}, check)},
  };
}

}  // namespace rigor::rules::simulate_cause_start_outside_limits
