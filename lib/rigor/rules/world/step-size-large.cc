// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>

#include <fmt/core.h>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::step_size_large {

// s. Of 600 real worlds none has more, and those of boats and balloons have this.
constexpr double kLarge = 0.02;

// s: what is meant where the number is in milliseconds.
constexpr double kMinMeant = 0.0005;

std::optional<Fix> in_seconds(const model::Field<double>& step) {
  const double meant = step.value / 1000;
  if (meant < kMinMeant || meant > kLarge) return std::nullopt;
  return Fix{"read it as milliseconds",
             Applicability::kUnsafe,
             {{step.span, fmt::format("{:.6g}", meant)}}};
}

void check(const model::Physics& physics, Context& context) {
  const auto& step = physics.max_step_size;
  if (!step.written || !(step.value > kLarge)) return;
  context.report(
      {.where = step.span,
       .message = fmt::format("the step size is {:.4g} s: most worlds have 0.001 s", step.value),
       .fix = in_seconds(step)});
}

Rule rule() {
  return {
      .name = "step-size-large",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "the step size of the physics is larger than 0.02 s",
      .why = "What falls for a meter moves 9 cm in such a step: it is deep in the ground, or "
             "through it, before the engine sees the contact. Joints with springs, damping or "
             "controllers shake. The number is in seconds; 1 is mostly a millisecond.",
      .what_to_do = "Write 0.001, or at most 0.005 where contacts matter.",
      .checks = {on<model::Physics>(check)},
  };
}

}  // namespace rigor::rules::step_size_large
