// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_start_moved {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("begins at {:.4g} {}: zero is outside its limits",
                                         fact.value, position_unit(fact))));
}

Rule rule() {
  return {
      .name = "simulate-start-moved",
      .category = Category::kSimulate,
      .severity = Severity::kInfo,
      .formats = Formats::kUrdf,
      .summary = "a joint whose limits leave zero out begins at the nearer one",
      .why =
          "URDF has no word for where a joint stands. A simulator that begins at zero, outside the "
          "limits, throws the joint to the nearer one in its first step.",
      .what_to_do =
          "Tell `--joint NAME=VALUE` where it stands; give the simulator that you use the same "
          "place "
          "to begin.",
      .bad = {{.text = R"(<robot name="crane">
  <link name="world"/>
  <link name="arm">
    <inertial>
      <origin xyz="0.2 0 0"/>
      <mass value="1"/>
      <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.02"/>
    </inertial>
  </link>
  <joint name="shoulder" type="revolute">
    <parent link="world"/>
    <child link="arm"/>
    <axis xyz="0 1 0"/>
    <«limit» lower="0.5" upper="1" effort="20" velocity="1"/>
  </joint>
</robot>
)"}},
      .good = {{.text = R"(<robot name="crane">
  <link name="world"/>
  <link name="arm">
    <inertial>
      <origin xyz="0.2 0 0"/>
      <mass value="1"/>
      <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.02"/>
    </inertial>
  </link>
  <joint name="shoulder" type="revolute">
    <parent link="world"/>
    <child link="arm"/>
    <axis xyz="0 1 0"/>
    <limit lower="-0.5" upper="1" effort="20" velocity="1"/>
  </joint>
</robot>
)"}},
      .checks = {on_simulation({simulate::FactKind::kStartMoved}, check)},
  };
}

}  // namespace rigor::rules::simulate_start_moved
