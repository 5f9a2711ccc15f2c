// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_joint_emulated {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(
      fact, fmt::format("the joint is emulated{}{}", fact.name.empty() ? "" : ": ", fact.name)));
}

Rule rule() {
  return {
      .name = "simulate-joint-emulated",
      .category = Category::kSimulate,
      .severity = Severity::kInfo,
      .summary = "a joint is simulated by means of others",
      .why =
          "The engine lacks the joint's type, so it is made of a free joint and a constraint "
          "between its motions. It is stiff but not perfect.",
      .what_to_do = "Nothing; look at `joint.anchor_error` when the joint bears much.",
      .checks = {on_simulation({simulate::FactKind::kJointEmulated}, check)},
  };
}

}  // namespace rigor::rules::simulate_joint_emulated
