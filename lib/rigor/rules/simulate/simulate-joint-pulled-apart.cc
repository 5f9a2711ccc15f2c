// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_joint_pulled_apart {

void check(const simulate::Fact& fact, Context& context) {
  context.report(
      shown(fact, fmt::format("the joint's two sides are {:.3g} mm apart (limit {:.3g} mm)",
                              1e3 * fact.value, 1e3 * fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-joint-pulled-apart",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "a joint is pulled apart",
      .why =
          "The two sides of the joint separate: the load or the ratio of masses is more than "
          "the solver can hold together, or a closed loop does not close.",
      .what_to_do =
          "Keep neighbouring masses within a factor of about 50; check that loops close at "
          "the start; use a smaller time step.",
      .bad = {{.text = R"(<sdf version='1.9'>
  <model name='pendulum'>
    <link name='rod'>
      <pose>0 0 2 0 0 0</pose>
      <inertial>
        <pose>0 0 -0.2 0 0 0</pose>
        <mass>0.001</mass>
        <inertia><ixx>1e-5</ixx><iyy>1e-5</iyy><izz>1e-5</izz></inertia>
      </inertial>
    </link>
    <link name='bob'>
      <pose>0 0 1.6 0 0 0</pose>
      <inertial>
        <pose>0 0 -0.2 0 0 0</pose>
        <mass>1000000</mass>
        <inertia><ixx>1e4</ixx><iyy>1e4</iyy><izz>1e4</izz></inertia>
      </inertial>
    </link>
    <joint name='pivot' type='ball'>
      <parent>world</parent>
      <child>rod</child>
    </joint>
    <joint name='«hinge»' type='ball'>
      <parent>rod</parent>
      <child>bob</child>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{.text = kArm}},
      .checks = {on_simulation({simulate::FactKind::kAnchorError}, check)},
  };
}

}  // namespace rigor::rules::simulate_joint_pulled_apart
