// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_cause_effort {

void check(const simulate::Fact& fact, Context& context) {
  const char* unit = fact.slides ? "N" : "N·m";
  context.report(stated(
      fact,
      fmt::format("carries {:.3g} {} and may use {:.3g} {}", fact.value, unit, fact.limit, unit),
      "raise the effort limit or lighten what it carries"));
}

Rule rule() {
  return {
      .name = "simulate-cause-effort",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "a joint's effort limit is below what it carries",
      .why = "At its limit the joint cannot hold the weight that hangs on it.",
      .what_to_do = "Raise `<effort>`, or make what it carries lighter.",
      .checks = {on_simulation({simulate::FactKind::kCauseEffort}, check)},
  };
}

}  // namespace rigor::rules::simulate_cause_effort
