// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_spawned_above {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("begins {:.3g} mm above the ground (limit {:.3g} mm)",
                                         1e3 * fact.value, 1e3 * fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-spawned-above",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "the model begins above the ground and falls",
      .why =
          "Every start is a drop test: joints are jerked, and what is measured first is the "
          "fall.",
      .what_to_do = "Lower the model's or the link's pose by the gap.",
      .bad = {{.text = R"(<sdf version='1.9'>
  <model name='«crate»'>
    <link name='body'>
      <pose>0 0 0.5 0 0 0</pose>
      <inertial>
        <mass>6</mass>
        <inertia><ixx>0.04</ixx><iyy>0.04</iyy><izz>0.04</izz></inertia>
      </inertial>
      <collision name='c'>
        <geometry><box><size>0.2 0.2 0.2</size></box></geometry>
      </collision>
    </link>
  </model>
</sdf>
)"}},
      .good = {{.text = kStandingBox}},
      .checks = {on_simulation({simulate::FactKind::kSpawnedAbove}, check)},
  };
}

}  // namespace rigor::rules::simulate_spawned_above
