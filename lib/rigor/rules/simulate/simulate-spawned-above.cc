// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <string>
#include <utility>

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_spawned_above {

std::string length_text(double metres) {
  return metres < 1 ? fmt::format("{:.3g} mm", 1e3 * metres) : fmt::format("{:.3g} m", metres);
}

void check(const simulate::Fact& fact, Context& context) {
  std::string message = "nothing in the world is below it: it falls, and its fall was not judged";
  if (std::isfinite(fact.value)) {
    message = fmt::format("begins {} above the ground (limit {})", length_text(fact.value),
                          length_text(fact.limit));
  }
  context.report(shown(fact, std::move(message)));
}

Rule rule() {
  return {
      .name = "simulate-spawned-above",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "the model begins above the ground and falls",
      .why =
          "Every start is a drop test: joints are jerked, and what is measured first is the "
          "fall. In a world, a model that falls for long is not judged by rest.",
      .what_to_do =
          "Lower the model's or the link's pose by the gap; give a world something to stand on.",
      .checks = {on_simulation({simulate::FactKind::kSpawnedAbove}, check)},
  };
}

}  // namespace rigor::rules::simulate_spawned_above
