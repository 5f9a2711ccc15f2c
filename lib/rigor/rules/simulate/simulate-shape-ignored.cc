// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_shape_ignored {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, "this collision is not simulated: " + fact.name));
}

Rule rule() {
  return {
      .name = "simulate-shape-ignored",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "a collision shape is not simulated",
      .why =
          "The engine has no such shape, a plane or heightmap is on a link that moves, a "
          "heightmap's picture cannot be used, or one collision has two shapes: what it should "
          "touch goes through it.",
      .what_to_do =
          "Use a box, sphere, cylinder, capsule, mesh or plane; for a heightmap a square PNG of "
          "2^n + 1 pixels along a side.",
      .bad = {{.text = R"(<sdf version='1.9'>
  <model name='crate'>
    <link name='body'>
      <pose>0 0 0.1 0 0 0</pose>
      <inertial>
        <mass>6</mass>
        <inertia><ixx>0.04</ixx><iyy>0.04</iyy><izz>0.04</izz></inertia>
      </inertial>
      <collision name='c'>
        <geometry><box><size>0.2 0.2 0.2</size></box></geometry>
      </collision>
      <collision name='floor'>
        <geometry><«plane»><normal>0 0 1</normal></plane></geometry>
      </collision>
    </link>
  </model>
</sdf>
)"}},
      .good = {{.text = kStandingBox}},
      .checks = {on_simulation({simulate::FactKind::kShapeIgnored}, check)},
  };
}

}  // namespace rigor::rules::simulate_shape_ignored
