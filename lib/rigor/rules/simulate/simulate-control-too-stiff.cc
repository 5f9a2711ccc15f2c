// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_control_too_stiff {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(
      fact,
      fmt::format(
          "damping times time step is {:.3g} times the inertia that it acts on (limit {:.3g})",
          fact.value, fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-control-too-stiff",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "damping or a gain is too large for the inertia and the time step",
      .why =
          "An explicit controller is stable only while d·h/I stays below 2: beyond, each step"
          " overshoots the one before. This is arithmetic and was found before the run.",
      .what_to_do =
          "Lower the gain or damping, give the link its true inertia, or use a smaller time "
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
commands = [{joint = "shoulder", position = 0.1, gains = [10, 0, 150], max-effort = 100}]
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
      .checks = {on_simulation({simulate::FactKind::kStiffControl}, check)},
  };
}

}  // namespace rigor::rules::simulate_control_too_stiff
