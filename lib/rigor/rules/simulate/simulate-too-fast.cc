// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_too_fast {

void check(const simulate::Fact& fact, Context& context) {
  const bool jerks = fact.name == "accel.peak";
  context.report(shown(
      fact, jerks ? fmt::format("is jerked with {:.3g} g (limit {:.3g} g)", fact.value, fact.limit)
                  : fmt::format("moves {:.3g} times as fast as falling by its own size and its "
                                "commands explain (limit {:.3g})",
                                fact.value, fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-too-fast",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "something moves faster than gravity and its motors could make it",
      .why =
          "A robot that is only set down, or driven gently, does not reach such speeds: "
          "contacts or joints push something apart.",
      .what_to_do =
          "Look for overlaps at the start (`rigor validate`), and for inertias that are too "
          "small.",
      .checks = {on_simulation({simulate::FactKind::kTooFast}, check)},
  };
}

}  // namespace rigor::rules::simulate_too_fast
