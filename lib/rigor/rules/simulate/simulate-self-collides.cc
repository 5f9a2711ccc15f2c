// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_self_collides {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(
      fact,
      fmt::format("collides with {} by {:.3g} mm",
                  fact.name.empty() ? "another link of the model" : fact.name, 1e3 * fact.value)));
}

Rule rule() {
  return {
      .name = "simulate-self-collides",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "links of the model collide with each other",
      .why =
          "They should pass each other, or their collision shapes are larger than what is "
          "drawn.",
      .what_to_do = "Make the collisions smaller, or limit the joint to where they do not meet.",
      .bad = {{.text = R"(<sdf version='1.9'>
  <model name='crate'>
    <self_collide>true</self_collide>
    <link name='body'>
      <pose>0 0 0.1 0 0 0</pose>
      <inertial>
        <mass>6</mass>
        <inertia><ixx>0.04</ixx><iyy>0.04</iyy><izz>0.04</izz></inertia>
      </inertial>
      <collision name='c'>
        <geometry><box><size>0.2 0.2 0.2</size></box></geometry>
      </collision>
    </link>
    <link name='lid'>
      <pose>0 0 0.25 0 0 0</pose>
      <inertial>
        <mass>6</mass>
        <inertia><ixx>0.04</ixx><iyy>0.04</iyy><izz>0.04</izz></inertia>
      </inertial>
      <collision name='c'>
        <geometry><«box»><size>0.2 0.2 0.2</size></box></geometry>
      </collision>
    </link>
  </model>
</sdf>
)"}},
      .good = {{.text = kStandingBox}},
      .checks = {on_simulation({simulate::FactKind::kSelfCollides}, check)},
  };
}

}  // namespace rigor::rules::simulate_self_collides
