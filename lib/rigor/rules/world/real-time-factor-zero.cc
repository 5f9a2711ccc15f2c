// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::real_time_factor_zero {

void check(const model::Physics& physics, Context& context) {
  const auto& factor = physics.real_time_factor;
  if (!factor.written || factor.value != 0) return;
  context.report(
      {.where = factor.span,
       .message = "the real time factor is 0: the world runs as fast as the machine can"});
}

Rule rule() {
  return {
      .name = "real-time-factor-zero",
      .severity = Severity::kInfo,
      .formats = Formats::kSdf,
      .summary = "the real time factor of the physics is zero",
      .why = "Gazebo Sim takes 0 as no limit and uses a whole core; controllers that run on the "
             "wall clock see a world that runs ahead of them. Tests and training want it.",
      .what_to_do = "Write 1 for real time.",
      .checks = {on<model::Physics>(check)},
  };
}

}  // namespace rigor::rules::real_time_factor_zero
