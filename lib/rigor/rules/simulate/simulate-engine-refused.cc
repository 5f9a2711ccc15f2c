// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_engine_refused {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("the engine stopped: {}", fact.name)));
}

Rule rule() {
  return {
      .name = "simulate-engine-refused",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the physics engine stopped",
      .why =
          "The engine met something that it cannot compute with, and would have ended the "
          "simulator. rigor checks all that it knows to cause this beforehand, so the cause "
          "is unusual.",
      .what_to_do =
          "Try another solver (`--solver`) or another step (`--time-step`); look at the "
          "joints and contacts that are active then.",
      .checks = {on_simulation({simulate::FactKind::kEngineRefused}, check)},
  };
}

}  // namespace rigor::rules::simulate_engine_refused
