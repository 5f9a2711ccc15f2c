// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_start_moved {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("begins at {:.4g} {}: zero is outside its limits",
                                         fact.value, position_unit(fact))));
}

Rule rule() {
  return {
      .name = "simulate-start-moved",
      .category = Category::kSimulate,
      .severity = Severity::kInfo,
      .formats = Formats::kUrdf,
      .summary = "a joint whose limits leave zero out begins at the nearer one",
      .why =
          "URDF has no word for where a joint stands. A simulator that begins at zero, outside the "
          "limits, throws the joint to the nearer one in its first step.",
      .what_to_do =
          "Tell `--joint NAME=VALUE` where it stands; give the simulator that you use the same "
          "place "
          "to begin.",
      .checks = {on_simulation({simulate::FactKind::kStartMoved}, check)},
  };
}

}  // namespace rigor::rules::simulate_start_moved
