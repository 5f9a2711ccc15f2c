// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_seed_sensitive {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("ends elsewhere with another seed, by {:.3g} % of its way "
                                         "or size (limit {:.3g} %)",
                                         100 * fact.value, 100 * fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-seed-sensitive",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "another seed of the solver gives another result",
      .why =
          "The model is chaotic, or the solver does not converge on it: tests of it will be "
          "flaky.",
      .what_to_do = "Give the solver more iterations; look for redundant contacts and mass ratios.",
      .checks = {on_simulation({simulate::FactKind::kSeedSensitive}, check)},
  };
}

}  // namespace rigor::rules::simulate_seed_sensitive
