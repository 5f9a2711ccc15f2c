// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_joint_jitters {

void check(const simulate::Fact& fact, Context& context) {
  context.report(
      shown(fact, fmt::format("the joint jitters with {:.3g} {}/s above 20 Hz (limit {:.3g})",
                              fact.value, position_unit(fact), fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-joint-jitters",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "a joint jitters",
      .why =
          "Its velocity changes faster than any command: a controller or spring that is too "
          "stiff for the inertia and the time step, or collisions that fight.",
      .what_to_do =
          "Give the link its true inertia, lower gains or stiffness, or use a smaller time "
          "step.",
      .bad = {{.text = R"(<!-- rigor simulate --scenario go.scenario.toml -->
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
      </axis>
    </joint>
  </model>
</sdf>
=== go.scenario.toml
schema = 1

[[step]]
name = "rest"
until = 0.5
commands = [{joint = "shoulder", position = 0.1, gains = [10, 0, 250], max-effort = 100}]
)"}},
      .good = {{.text = R"(<!-- rigor simulate --scenario go.scenario.toml -->
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
    <joint name='shoulder' type='revolute'>
      <parent>world</parent>
      <child>arm</child>
      <axis>
        <xyz>0 1 0</xyz>
      </axis>
    </joint>
  </model>
</sdf>
=== go.scenario.toml
schema = 1

[[step]]
name = "reach"
until = 1
commands = [{joint = "shoulder", position = 0.05, gains = [100, 0, 5], max-effort = 100}]

[[step]]
name = "rest"
until = 1.5
commands = [{joint = "shoulder", position = 0.05, gains = [100, 0, 5], max-effort = 100}]
)"}},
      .checks = {on_simulation({simulate::FactKind::kJointJitters}, check)},
  };
}

}  // namespace rigor::rules::simulate_joint_jitters
