// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_spawned_in_ground {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("begins {:.3g} mm inside the ground (limit {:.3g} mm)",
                                         1e3 * fact.value, 1e3 * fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-spawned-in-ground",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the model begins inside the ground",
      .why =
          "The engine pushes it out: with SDFormat's default of 100 m/s a centimetre becomes "
          "a jump of metres; with Gazebo's own limit it rises slowly and shakes.",
      .what_to_do = "Raise the model's or the link's pose by the depth.",
      .checks = {on_simulation({simulate::FactKind::kSpawnedInGround}, check)},
  };
}

}  // namespace rigor::rules::simulate_spawned_in_ground
