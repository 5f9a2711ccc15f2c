// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/rules/plugin/drive_wheels.h>
#include <rigor/rules/plugin/systems.h>
#include <rigor/rules/rule.h>
#include <rigor/write/numbers.h>

namespace rigor::rules::controller_without_gain {

bool has_gain(const model::Parameter& parameter) {
  const auto number = write::number_in(parameter.value.value);
  return !number || *number != 0;  // a malformed one is reported elsewhere
}

/// Whether its topic says that the trajectories hold efforts, which need no gains: nothing else tells.
bool is_for_efforts(const model::Plugin& plugin) {
  const auto* topic = find(plugin.parameters, "topic");
  if (topic == nullptr) return false;
  for (const std::string_view word : {"effort", "force", "torque"}) {
    if (topic->value.value.find(word) != std::string::npos) return true;
  }
  return false;
}

/// Of a trajectory: the gains are lists, and all of them are 0 where they are not written.
void check_trajectory(const model::Plugin& plugin, Context& context) {
  const model::Parameter* zero = nullptr;
  for (const model::Parameter& given : plugin.parameters) {
    if (!given.name.ends_with("_gain") && !given.name.ends_with("_cmd_offset")) continue;
    if (has_gain(given)) return;
    if (zero == nullptr) zero = &given;
  }
  if (zero == nullptr && is_for_efforts(plugin)) return;
  context.report({.where = zero != nullptr ? trimmed(*zero, context) : plugin.site.name,
                  .message = zero != nullptr
                                 ? "all gains of the trajectory controller are 0: it puts out no "
                                   "force for an error"
                                 : "the trajectory controller has no gains, and their defaults are "
                                   "0: it puts out no force for an error",
                  .subject = context.subject(plugin),
                  .help = "write <position_p_gain>, once for each joint"});
}

/// Of a position: only gains that are written are 0, since the defaults are 1, 0.1 and 0.01.
void check_position(const model::Plugin& plugin, Context& context) {
  const auto* at_speed = find(plugin.parameters, "use_velocity_commands");
  const auto* p = find(plugin.parameters, "p_gain");
  if ((at_speed != nullptr && model::is_true(*at_speed)) || p == nullptr || has_gain(*p)) return;
  const auto* i = find(plugin.parameters, "i_gain");
  const bool integrates = i == nullptr || has_gain(*i);
  context.report({.where = trimmed(*p, context),
                  .message = integrates
                                 ? "<p_gain> is 0: only the integral of the error drives the "
                                   "joint, which overshoots or stays away"
                                 : "<p_gain> and <i_gain> are 0: nothing drives the joint to "
                                   "a position",
                  .subject = context.subject(plugin)});
}

void check(const model::Plugin& plugin, Context& context) {
  const GazeboSystem* const system = gazebo_system(plugin.filename.value);
  if (system == nullptr) return;
  if (system->library == "joint-trajectory-controller") check_trajectory(plugin, context);
  if (system->library == "joint-position-controller") check_position(plugin, context);
}

Rule rule() {
  return {
      .name = "controller-without-gain",
      .severity = Severity::kWarning,
      .summary = "a joint controller of gz-sim has no gain",
      .why =
          "gz-sim's JointTrajectoryController adds the outputs of a position and a velocity "
          "PID whose gains are 0 unless they are written, and the efforts of the trajectory: "
          "without gains it moves nothing to a position. A topic with effort, force or torque in "
          "its name says that the trajectories hold efforts. JointPositionController needs its "
          "proportional gain, unless it commands velocities.",
      .what_to_do = "Write the gains, in N·m/rad or N/m; remove one that is 0 to have the default "
                    "of the position controller, 1.",
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::controller_without_gain
