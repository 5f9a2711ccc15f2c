// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_limit_violated {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("goes {:.3g} {} beyond its limit (allowed {:.3g})",
                                         fact.value, position_unit(fact), fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-limit-violated",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "a joint goes beyond its limit",
      .why = "The stop gives way, or the joint begins outside its limits and is thrown back.",
      .what_to_do = "Put the start inside the limits; check the load that the stop must bear.",
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
    <joint name='«shoulder»' type='revolute'>
      <parent>world</parent>
      <child>arm</child>
      <axis>
        <xyz>0 1 0</xyz>
        <limit><lower>0.5</lower><upper>1</upper></limit>
      </axis>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{.text = kArm}},
      .checks = {on_simulation({simulate::FactKind::kLimitViolated}, check)},
  };
}

}  // namespace rigor::rules::simulate_limit_violated
