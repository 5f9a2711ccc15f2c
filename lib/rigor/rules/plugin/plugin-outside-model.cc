// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

#include <rigor/rules/plugin/systems.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::plugin_outside_model {

/// Systems that look for the model that they stand in, and give up without one.
constexpr std::string_view kOfModels[] = {"ackermann-steering",
                                          "apply-joint-force",
                                          "detachable-joint",
                                          "diff-drive",
                                          "joint-controller",
                                          "joint-position-controller",
                                          "joint-state-publisher",
                                          "joint-trajectory-controller",
                                          "lift-drag",
                                          "linearbatteryplugin",
                                          "mecanum-drive",
                                          "multicopter-control",
                                          "multicopter-motor-model",
                                          "odometry-publisher",
                                          "pose-publisher",
                                          "thruster",
                                          "track-controller",
                                          "tracked-vehicle",
                                          "trajectory-follower",
                                          "velocity-control",
                                          "wheel-slip"};

void check(const model::Plugin& plugin, Context& context) {
  if (!plugin.world) return;
  const GazeboSystem* const system = gazebo_system(plugin.filename.value);
  if (system == nullptr) return;
  if (std::find(std::begin(kOfModels), std::end(kOfModels), system->library) ==
      std::end(kOfModels)) {
    return;
  }
  context.report({.where = plugin.site.name,
                  .message = "the system " + std::string(system->classes) +
                             " stands in the world; it works on the model that it stands in",
                  .subject = context.subject(plugin)});
}

Rule rule() {
  return {
      .name = "plugin-outside-model",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "a system for a model stands in the world",
      .why = "Drives, controllers and publishers of new Gazebo act on the model that holds them. "
             "In a world they write \"should be attached to a model entity. Failed to "
             "initialize.\" to the log, and do nothing.",
      .what_to_do = "Move the plugin into the model that it is to drive.",
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::plugin_outside_model
