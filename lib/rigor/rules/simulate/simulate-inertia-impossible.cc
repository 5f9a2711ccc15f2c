// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_inertia_impossible {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("no rigid body has this inertia: {:.3g} kg·m² where more "
                                         "than {:.3g} is needed",
                                         fact.value, fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-inertia-impossible",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "no rigid body has the inertia tensor",
      .why =
          "A tensor must be positive definite, and two principal moments must sum up to the "
          "third at least. ODE ends the process on the first, and integrates the second into "
          "motions that gain energy.",
      .what_to_do =
          "Run `rigor inertia MODEL --diff`: it shows the tensor that the link's shapes have.",
      .bad = {{.text = R"(<sdf version='1.9'>
  <model name='crate'>
    <link name='body'>
      <pose>0 0 0.1 0 0 0</pose>
      <inertial>
        <mass>6</mass>
        «<inertia><ixx>0.4</ixx><iyy>0.04</iyy><izz>0.04</izz></inertia>»
      </inertial>
      <collision name='c'>
        <geometry><box><size>0.2 0.2 0.2</size></box></geometry>
      </collision>
    </link>
  </model>
</sdf>
)"}},
      .good = {{.text = kStandingBox}},
      .checks = {on_simulation({simulate::FactKind::kInertiaImpossible}, check)},
  };
}

}  // namespace rigor::rules::simulate_inertia_impossible
