// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::real_time_factor_negative {

void check(const model::Physics& physics, Context& context) {
  const auto& factor = physics.real_time_factor;
  if (!factor.written || factor.value >= 0) return;
  context.report({.where = factor.span,
                  .message = fmt::format("the real time factor is {}: time cannot run in reverse",
                                         factor.value),
                  .fix = Fix{"run in real time", Applicability::kUnsafe, {{factor.span, "1"}}}});
}

Rule rule() {
  return {
      .name = "real-time-factor-negative",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "the real time factor of the physics is negative",
      .why = "Gazebo Sim computes the pause between steps from it, and a negative pause has no "
             "meaning. The factor is simulated time over wall time: 1 is real time, 0 as fast as "
             "can be.",
      .what_to_do = "Write 1 for real time, 0.5 for half of it, 0 for as fast as can be.",
      .checks = {on<model::Physics>(check)},
  };
}

}  // namespace rigor::rules::real_time_factor_negative
