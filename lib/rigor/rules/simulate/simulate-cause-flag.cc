// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_cause_flag {

void check(const simulate::Fact& fact, Context& context) {
  context.report(stated(fact,
                        fact.name == "kinematic" ? "is kinematic: no force moves it"
                        : fact.name == "max_contacts"
                            ? "has a max_contacts of 0: it touches nothing"
                            : "gravity does not act on it, as it does on other links of the model",
                        "take the flag out"));
}

Rule rule() {
  return {
      .name = "simulate-cause-flag",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "forces or gravity do not act on a link",
      .why =
          "A kinematic link moves as it is told and by nothing else; one without gravity hangs in "
          "the air and puts no weight on the wheels.",
      .what_to_do = "Take out `<kinematic>` and `<gravity>false` where they were left by mistake.",
      .checks = {on_simulation({simulate::FactKind::kCauseFlag}, check)},
  };
}

}  // namespace rigor::rules::simulate_cause_flag
