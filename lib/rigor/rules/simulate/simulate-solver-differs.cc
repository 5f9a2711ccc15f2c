// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
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
      .checks = {on_simulation({simulate::FactKind::kSolverDiffers}, check)},
  };
}

}  // namespace rigor::rules::simulate_solver_differs
