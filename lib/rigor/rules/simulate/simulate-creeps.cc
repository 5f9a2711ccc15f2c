// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_creeps {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(
      fact, fact.name == "yaw" ? fmt::format("turns with {:.3g} rad/s at rest (limit {:.3g} rad/s)",
                                             fact.value, fact.limit)
                               : fmt::format("creeps with {:.3g} mm/s at rest (limit {:.3g} mm/s)",
                                             1e3 * fact.value, 1e3 * fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-creeps",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the model creeps at rest",
      .why =
          "It moves or turns on level ground without a command. A robot that is parked must be "
          "where it was parked.",
      .what_to_do =
          "Check that what it stands on is symmetric, that wheels are not driven by a spring "
          "or by gravity, and the friction of its contacts.",
      .checks = {on_simulation({simulate::FactKind::kCreeps}, check)},
  };
}

}  // namespace rigor::rules::simulate_creeps
