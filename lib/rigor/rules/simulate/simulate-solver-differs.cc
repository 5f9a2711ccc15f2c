// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_solver_differs {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(
      fact,
      fact.name == "solver.agreement"
          ? fmt::format("ends elsewhere with the other solver, by {:.3g} % of its way or size "
                        "(limit {:.3g} %)",
                        100 * fact.value, 100 * fact.limit)
          : fmt::format("{} is the solver's: other solvers, steps or seeds do not show it",
                        fact.name)));
}

Rule rule() {
  return {
      .name = "simulate-solver-differs",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "the other solver gives another result",
      .why =
          "What was seen is as much the solver's doing as the model's; it is not called a "
          "failure of the model.",
      .what_to_do =
          "Try `--solver dantzig`, or more `--iterations`, and judge by what both agree on.",
      .bad = {{.text = R"(<sdf version='1.9'>
  <model name='«pendulum»'>
    <link name='rod'>
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
      .good = {{.text = kStandingBox}},
      .checks = {on_simulation({simulate::FactKind::kSolverDiffers}, check)},
  };
}

}  // namespace rigor::rules::simulate_solver_differs
