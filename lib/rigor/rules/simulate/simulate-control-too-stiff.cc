// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
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
      .checks = {on_simulation({simulate::FactKind::kStiffControl}, check)},
  };
}

}  // namespace rigor::rules::simulate_control_too_stiff
