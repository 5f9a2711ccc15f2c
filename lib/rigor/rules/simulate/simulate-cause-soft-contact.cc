// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_cause_soft_contact {

void check(const simulate::Fact& fact, Context& context) {
  context.report(stated(fact,
                        fmt::format("with its kp the model sinks {:.3g} mm into the ground where a "
                                    "simulator honours it",
                                    1e3 * fact.value),
                        "raise kp or take it out"));
}

Rule rule() {
  return {
      .name = "simulate-cause-soft-contact",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "a contact is too soft for the weight on it",
      .why =
          "A simulator that honours `<kp>` lets the model sink by its weight over the stiffness "
          "of its contacts, and wheels stick.",
      .what_to_do = "Raise `<kp>` of the contact, or take it out: the default is as good as rigid.",
      .checks = {on_simulation({simulate::FactKind::kCauseSoftContact}, check)},
  };
}

}  // namespace rigor::rules::simulate_cause_soft_contact
