// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_axis_zero {
namespace {

std::string words_for(std::string_view name) {
  if (name == "axis" || name == "axis2") return "there is no <" + std::string(name) + ">";
  if (name == "axis2 along axis") return "both axes of the joint point along one line";
  if (name == "normal") return "the plane's normal is 0 0 0: it has no direction";
  return "the axis is 0 0 0: it has no direction";
}

}  // namespace

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, words_for(fact.name)));
}

Rule rule() {
  return {
      .name = "simulate-axis-zero",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "an axis has no direction",
      .why = "A hinge about 0 0 0 turns about nothing; ODE ends the process on it.",
      .what_to_do = "Write the direction that the joint turns about or slides along.",
      .checks = {on_simulation({simulate::FactKind::kAxisZero}, check)},
  };
}

}  // namespace rigor::rules::simulate_axis_zero
