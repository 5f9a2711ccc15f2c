// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_cause_no_collision {

void check(const simulate::Fact& fact, Context& context) {
  context.report(stated(fact, "nothing of it that moves has a collision", "give its links some"));
}

Rule rule() {
  return {
      .name = "simulate-cause-no-collision",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "nothing of the model collides",
      .why = "It goes through the ground and through everything else.",
      .what_to_do = "Give it a collision.",
      .checks = {on_simulation({simulate::FactKind::kCauseNoCollision}, check)},
  };
}

}  // namespace rigor::rules::simulate_cause_no_collision
