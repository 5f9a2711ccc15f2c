// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_self_overlap {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("overlaps {} by {:.3g} mm at the start (limit {:.3g} mm)",
                                         fact.name.empty() ? "another link" : fact.name,
                                         1e3 * fact.value, 1e3 * fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-self-overlap",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "links that no joint connects overlap where the model begins",
      .why =
          "When they collide, the engine pushes them apart with all it has: this is what "
          "makes robots explode when they are spawned.",
      .what_to_do = "Move one of them, make a collision smaller, or connect them by a joint.",
      .checks = {on_simulation({simulate::FactKind::kSelfOverlap}, check)},
  };
}

}  // namespace rigor::rules::simulate_self_overlap
