// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_cause_mass_ratio {

void check(const simulate::Fact& fact, Context& context) {
  context.report(stated(fact,
                        fmt::format("a joint connects it to {}, which is {:.3g} times as heavy",
                                    fact.name, fact.value),
                        "keep neighbouring masses within a factor of about 50"));
}

Rule rule() {
  return {
      .name = "simulate-cause-mass-ratio",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "neighbouring masses are far apart",
      .why =
          "Iterative solvers need about as many iterations as the ratio of masses across a "
          "joint.",
      .what_to_do =
          "Keep the ratio within about 50: make light links heavier or join them to their "
          "neighbours.",
      .bad = {{.text = R"(<sdf version='1.9'>
  <model name='pendulum'>
    <link name='«rod»'>
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
        <mass>1000</mass>
        <inertia><ixx>10</ixx><iyy>10</iyy><izz>10</izz></inertia>
      </inertial>
    </link>
    <joint name='pivot' type='ball'>
      <parent>world</parent>
      <child>rod</child>
    </joint>
    <joint name='hinge' type='ball'>
      <parent>rod</parent>
      <child>bob</child>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{.text = kArm}},
      .checks = {on_simulation({simulate::FactKind::kCauseMassRatio}, check)},
  };
}

}  // namespace rigor::rules::simulate_cause_mass_ratio
