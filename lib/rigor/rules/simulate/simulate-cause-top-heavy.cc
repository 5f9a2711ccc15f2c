// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_cause_top_heavy {

void check(const simulate::Fact& fact, Context& context) {
  context.report(stated(fact,
                        fact.value > 0
                            ? fmt::format("a slope of {:.3g}° tips it over", fact.value * kDegrees)
                            : "its centre of mass is not above what it stands on",
                        "lower the centre of mass or widen the stance"));
}

Rule rule() {
  return {
      .name = "simulate-cause-top-heavy",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "the centre of mass is high above a narrow stance",
      .why = "The slope that tips it is the ratio of the stance to the height.",
      .what_to_do = "Lower the centre of mass, or widen the stance.",
      .checks = {on_simulation({simulate::FactKind::kCauseTopHeavy}, check)},
  };
}

}  // namespace rigor::rules::simulate_cause_top_heavy
