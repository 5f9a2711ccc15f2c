// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_solver_setting {

void check(const simulate::Fact& fact, Context& context) {
  const char* demand = fact.value > fact.limit   ? "at most"
                       : fact.value < fact.limit ? "not below"
                                                 : "above";
  context.report(shown(fact, fmt::format("{} is {:.6g}, and must be {} {:.6g}", fact.name,
                                         fact.value, demand, fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-solver-setting",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "a setting of the physics engine is not one that it can take",
      .why =
          "Time must go forward, and corrections must not overshoot: ODE ends the process on a "
          "step of "
          "zero or less.",
      .what_to_do =
          "Take it out of `<physics>`, or write a usual one: `<max_step_size>` 0.001 s, `<iters>` "
          "50, "
          "`<sor>` 1.3, `<erp>` 0.2, `<cfm>` 0.",
      .checks = {on_simulation({simulate::FactKind::kStep}, check)},
  };
}

}  // namespace rigor::rules::simulate_solver_setting
