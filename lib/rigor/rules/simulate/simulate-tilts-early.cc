// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_tilts_early {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("tips at {:.3g} % of the slope that its stance allows "
                                         "(at least {:.3g} % is expected)",
                                         100 * fact.value, 100 * fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-tilts-early",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the model tips at a smaller slope than its stance says",
      .why =
          "On a table that tilts it falls before its centre of mass has passed the edge of what "
          "it stands on: some part of it swings, rolls or slides down first.",
      .what_to_do = "Lower the centre of mass, widen the stance, and look for parts that swing.",
      .bad = {{.text = R"(<!-- rigor simulate --test tilt-table -->
<sdf version='1.11'>
  <model name='«lamp»'>
    <link name='base'>
      <pose>0 0 0.01 0 0 0</pose>
      <inertial auto='true'/>
      <collision name='c'>
        <geometry><box><size>0.3 0.3 0.02</size></box></geometry>
      </collision>
    </link>
    <link name='bob'>
      <pose>0 0 0.6 0 0 0</pose>
      <inertial>
        <pose>0 0 -0.4 0 0 0</pose>
        <mass>10</mass>
        <inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.01</izz></inertia>
      </inertial>
    </link>
    <joint name='hook' type='ball'>
      <parent>base</parent>
      <child>bob</child>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{.text = kStandingBox}},
      .checks = {on_simulation({simulate::FactKind::kTiltsEarly}, check)},
  };
}

}  // namespace rigor::rules::simulate_tilts_early
