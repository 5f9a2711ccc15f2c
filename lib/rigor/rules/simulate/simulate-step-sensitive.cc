// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_step_sensitive {

void check(const simulate::Fact& fact, Context& context) {
  context.report(
      shown(fact, fmt::format("ends elsewhere with half the time step, by {:.3g} % of its "
                              "way or size (limit {:.3g} %)",
                              100 * fact.value, 100 * fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-step-sensitive",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "half the time step gives another result",
      .why =
          "The model is at the edge of what can be computed with this step: small changes "
          "will break it.",
      .what_to_do = "Use a smaller `<max_step_size>`; look for stiff springs and small inertias.",
      .checks = {on_simulation({simulate::FactKind::kStepSensitive}, check)},
  };
}

}  // namespace rigor::rules::simulate_step_sensitive
