// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_tilts_early {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("tips at {:.3g} % of the slope that its stance allows "
                                         "(at least {:.3g} % is expected)",
                                         100 * fact.value, 100 * fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-tilts-early",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the model tips at a smaller slope than its stance says",
      .why =
          "On a table that tilts it falls before its centre of mass has passed the edge of what "
          "it stands on: some part of it swings, rolls or slides down first.",
      .what_to_do = "Lower the centre of mass, widen the stance, and look for parts that swing.",
      .checks = {on_simulation({simulate::FactKind::kTiltsEarly}, check)},
  };
}

}  // namespace rigor::rules::simulate_tilts_early
