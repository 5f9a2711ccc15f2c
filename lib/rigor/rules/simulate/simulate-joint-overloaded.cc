// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_joint_overloaded {
namespace {

std::string overload_of(const simulate::Fact& fact) {
  if (fact.name == "drive.reached") {
    return fmt::format(
        "the wheels turn {:.3g} % of what they are told to (at least {:.3g} % is "
        "expected), this one least",
        100 * fact.value, 100 * fact.limit);
  }
  if (fact.name == "joint.reach") {
    return fmt::format(
        "gives all its effort, and {:.3g} % of its way is out of reach (limit "
        "{:.3g} %)",
        100 * fact.value, 100 * fact.limit);
  }
  if (fact.name == "hold.error") {
    return fmt::format("gives all its effort, and is {:.3g} {} off (limit {:.3g})", fact.value,
                       position_unit(fact), fact.limit);
  }
  return fmt::format("needs {:.3g} % of its effort limit (limit {:.3g} %)", 100 * fact.value,
                     100 * fact.limit);
}

}  // namespace

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, overload_of(fact)));
}

Rule rule() {
  return {
      .name = "simulate-joint-overloaded",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "a joint needs all the effort that its limit allows",
      .why = "The joint follows its commands late or not at all.",
      .what_to_do =
          "Raise `<effort>` to what the actuator can give, or make what it carries lighter.",
      .checks = {on_simulation({simulate::FactKind::kJointOverloaded}, check)},
  };
}

}  // namespace rigor::rules::simulate_joint_overloaded
