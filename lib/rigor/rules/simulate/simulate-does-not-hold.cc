// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_does_not_hold {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("is {:.3g} {} off when it is to hold (limit {:.3g})",
                                         fact.value, position_unit(fact), fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-does-not-hold",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the joints do not hold their position",
      .why =
          "With a controller on each joint the pose is off or swings: the joint begins outside "
          "its limits, something pushes it, or it cannot be controlled at this time step.",
      .what_to_do =
          "Put the start inside the limits, give the links their true inertia, or use a smaller "
          "time step.",
      .bad = {{.text = R"(<!-- rigor simulate --test hold -->
<sdf version='1.9'>
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
      .checks = {on_simulation({simulate::FactKind::kDoesNotHold}, check)},
  };
}

}  // namespace rigor::rules::simulate_does_not_hold
