// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_cause_default_inertia {

void check(const simulate::Fact& fact, Context& context) {
  context.report(stated(fact,
                        fact.value > 0
                            ? fmt::format("has no inertial, so it gets 1 kg and 1 kg·m²: "
                                          "{:.3g} times the inertia of its shape",
                                          fact.value)
                            : fmt::format("has no inertial, so it gets 1 kg and 1 kg·m²"),
                        "run `rigor inertia MODEL --write`"));
}

Rule rule() {
  return {
      .name = "simulate-cause-default-inertia",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "a link has the default inertia: 1 kg and 1 kg·m²",
      .why =
          "Nothing was written, so the simulator takes a body of 1 kg whose moments are those of "
          "a ball three metres wide.",
      .what_to_do = "Run `rigor inertia MODEL --write`.",
      .checks = {on_simulation({simulate::FactKind::kCauseDefaultInertia}, check)},
  };
}

}  // namespace rigor::rules::simulate_cause_default_inertia
