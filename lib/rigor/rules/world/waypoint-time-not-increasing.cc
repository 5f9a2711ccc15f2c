// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>

#include <fmt/core.h>

#include <rigor/rules/rule.h>

namespace rigor::rules::waypoint_time_not_increasing {

/// Reported once for a trajectory: one wrong time may be followed by many.
void look_at(const model::Trajectory& trajectory, const model::Actor& actor, Context& context) {
  std::optional<model::Field<double>> before;
  for (const model::Field<double>& time : trajectory.times) {
    if (!time.written) continue;
    if (before && time.value <= before->value) {
      context.report({.where = time.span,
                      .message = fmt::format("the actor '{}' is to be here at {} s, and at the "
                                             "waypoint before at {} s",
                                             actor.name.value, time.value, before->value),
                      .related = {{before->span, "the time before"}}});
      return;
    }
    before = time;
  }
}

void check(const model::Root& root, Context& context) {
  for (const model::Actor& actor : root.actors) {
    if (!root.own(actor.site)) continue;
    for (const model::Trajectory& each : actor.trajectories) look_at(each, actor, context);
  }
}

Rule rule() {
  return {
      .name = "waypoint-time-not-increasing",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "a waypoint of an actor is not later than the one before it",
      .why = "Gazebo sorts waypoints by their time, so the actor takes another way than the file "
             "shows; of two with one time it takes the last.",
      .what_to_do = "Write times that rise, in seconds since the script started.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::waypoint_time_not_increasing
