// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <utility>

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_element_ignored {

void check(const simulate::Fact& fact, Context& context) {
  std::string message = fact.name + " has no effect in this simulation";
  if (fact.name == "model" || fact.name == "world") {
    message = "this " + fact.name + " is not simulated: only the first one of a file is";
  } else if (fact.name == "include") {
    message =
        "this include is not simulated: it is not in the Fuel cache, and nothing is downloaded";
  } else if (fact.kind == simulate::FactKind::kDampingAsNone) {
    message =
        fmt::format("{} of {:.6g} would drive the joint: it is taken as 0", fact.name, fact.value);
  }
  context.report(shown(fact, std::move(message)));
}

Rule rule() {
  return {
      .name = "simulate-element-ignored",
      .category = Category::kSimulate,
      .severity = Severity::kInfo,
      .summary = "an element that the model relies on has no effect here",
      .why =
          "What the element asks for exists in Gazebo's own engine only, or in none; "
          "docs/simulate.md lists what is honoured, approximated and ignored.",
      .what_to_do = "Nothing, if the behaviour without it is what you want to see.",
      .checks = {on_simulation(
          {simulate::FactKind::kElementIgnored, simulate::FactKind::kDampingAsNone}, check)},
  };
}

}  // namespace rigor::rules::simulate_element_ignored
