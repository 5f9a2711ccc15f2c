// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_engine_refused {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("the engine stopped: {}", fact.name)));
}

Rule rule() {
  return {
      .name = "simulate-engine-refused",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the physics engine stopped",
      .why =
          "The engine met something that it cannot compute with, and would have ended the "
          "simulator. rigor checks all that it knows to cause this beforehand, so the cause "
          "is unusual.",
      .what_to_do =
          "Try another solver (`--solver`) or another step (`--time-step`); look at the "
          "joints and contacts that are active then.",
      .bad = {{.text = R"(<sdf version='1.11'>
  <world name='w'>
    <physics type='ode'>
      <max_step_size>1e-9</max_step_size>
    </physics>
    <model name='crate'>
      <link name='body'>
        <pose>0 0 0.1 0 0 0</pose>
        <inertial auto='true'/>
        <collision name='c'>
          <geometry><box><size>0.2 0.2 0.2</size></box></geometry>
        </collision>
      </link>
    </model>
  </world>
</sdf>
)"}},
      .good = {{.text = kStandingBox}},
      .checks = {on_simulation({simulate::FactKind::kEngineRefused}, check)},
  };
}

}  // namespace rigor::rules::simulate_engine_refused
