// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_energy_gained {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(
      fact, fmt::format("gains {:.3g} of the energy of lifting it by its own size (limit {:.3g})",
                        fact.value, fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-energy-gained",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "energy appears from nowhere",
      .why =
          "Nothing put it in: an overlap is pushed apart, a controller or spring is too stiff"
          " for the time step, or an inertia is not that of a rigid body.",
      .what_to_do =
          "Mend what overlaps at the start; give small links their true inertia; use a "
          "smaller time step.",
      .checks = {on_simulation({simulate::FactKind::kEnergyGained}, check)},
  };
}

}  // namespace rigor::rules::simulate_energy_gained
