// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::effort_velocity_placeholder {

// Fewer joints may be of the same motor.
constexpr std::size_t kFewest = 3;

// A template has a round number that is too large for a speed; some small robots do move at 10 rad/s.
constexpr double kSmallest = 100;  // rad/s or m/s

bool is_power_of_ten(double value) {
  const double exponent = std::log10(value);
  return std::abs(exponent - std::round(exponent)) < 1e-9;
}

void check(const model::Model& robot, Context& context) {
  const model::Root& root = context.root();
  std::vector<const model::Axis*> limited;
  for (const auto id : robot.joints) {
    for (const model::Axis& axis : root[id].axes) {
      if (axis.mimic || !has_axis(root[id].type)) continue;
      if (axis.effort.written && axis.velocity.written) limited.push_back(&axis);
    }
  }
  if (limited.size() < kFewest || !root.own(robot.site)) return;
  const double value = limited.front()->velocity.value;
  if (!(value >= kSmallest) || !std::isfinite(value) || !is_power_of_ten(value)) return;
  for (const model::Axis* axis : limited) {
    if (axis->velocity.value != value || axis->effort.value != value) return;
  }
  context.report({.where = limited.front()->velocity.span,
                  .message = fmt::format("effort and velocity limits of all {} joints are {:.6g}: "
                                         "they look like a placeholder",
                                         limited.size(), value),
                  .subject = context.subject(robot)});
}

Rule rule() {
  return {
      .name = "effort-velocity-placeholder",
      .severity = Severity::kInfo,
      .summary = "effort and velocity limits of all joints are one round number",
      .why = "MoveIt times its trajectories by the velocity limit, and controllers clamp commands "
             "to both: such limits protect no motor. Exporters write 100 or 1000 for both until "
             "they are filled in.",
      .what_to_do = "Write the maximum effort and velocity of each motor from its data sheet.",
      .checks = {on<model::Model>(check)},
  };
}

}  // namespace rigor::rules::effort_velocity_placeholder
