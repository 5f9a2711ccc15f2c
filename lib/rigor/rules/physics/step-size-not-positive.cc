// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>

namespace rigor::rules::step_size_not_positive {

void check(const model::Physics& physics, Context& context) {
  const auto& step = physics.max_step_size;
  if (!step.written || step.value > 0) return;
  context.report(
      {.where = step.span,
       .message = fmt::format("the step size is {} s: it must be above zero", step.value)});
}

Rule rule() {
  return {
      .name = "step-size-not-positive",
      .severity = Severity::kError,
      .formats = Formats::kSdf,
      .summary = "the step size of the physics is zero or negative",
      .why = "ign sdf -k calls it valid. Simulated time then stands still, or the simulator "
             "refuses to start.",
      .what_to_do = "Write a time in seconds; 0.001 is what most worlds use.",
      .checks = {on<model::Physics>(check)},
  };
}

}  // namespace rigor::rules::step_size_not_positive
