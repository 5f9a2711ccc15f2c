// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_assertion {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, std::isnan(fact.value)
                                 ? fmt::format("{}: there is no such number in this run", fact.name)
                                 : fmt::format("{}: it is {:.6g}, beyond {:.6g}", fact.name,
                                               fact.value, fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-assertion",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "an assertion of the scenario does not hold",
      .why = "The author of the scenario demanded it, and the model does not keep to it.",
      .what_to_do = "Mend the model, or the assertion.",
      .checks = {on_simulation({simulate::FactKind::kAssertion}, check)},
  };
}

}  // namespace rigor::rules::simulate_assertion
