// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_restless {

void check(const simulate::Fact& fact, Context& context) {
  const bool flickers = fact.name == "rest.contacts";
  context.report(shown(
      fact, flickers
                ? fmt::format("contacts come and go {:.3g} times a second at rest (limit {:.3g})",
                              fact.value, fact.limit)
                : fmt::format("still moves with {:.3g} mm/s at rest (limit {:.3g} mm/s)",
                              1e3 * fact.value, 1e3 * fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-restless",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the model trembles at rest",
      .why =
          "What should stand still moves: sensors see noise that no real robot has, and the "
          "pose drifts.",
      .what_to_do =
          "Replace mesh collisions of what stands on the ground by primitives, and give small"
          " links their true inertia.",
      .checks = {on_simulation({simulate::FactKind::kRestless}, check)},
  };
}

}  // namespace rigor::rules::simulate_restless
