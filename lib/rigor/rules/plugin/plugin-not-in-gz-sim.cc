// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/plugin/simulator.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::plugin_not_in_gz_sim {

// From SDF 1.8, which Gazebo classic does not read, plugin-classic tells it whoever the file is for.
constexpr int kFirstWithoutClassic = 8;

void check(const model::Plugin& plugin, Context& context) {
  const std::string& library = plugin.filename.value;
  if (context.is_sdf() && context.root().version >= kFirstWithoutClassic) return;
  if (!is_of_gazebo_classic(library)) return;
  context.report(
      {.where = plugin.filename.span,
       .message = "'" + library + "' is a plugin of Gazebo classic: gz-sim cannot load it",
       .subject = context.subject(plugin)});
}

Rule rule() {
  return {
      .name = "plugin-not-in-gz-sim",
      .severity = Severity::kWarning,
      .targets = {Target::kGzSim},
      .summary = "a plugin of Gazebo classic in a model for gz-sim",
      .why = "gz-sim loads libraries of its own kind only. It says at the start that it cannot "
             "load this one, and goes on without what it would do.",
      .what_to_do = "Use the system of gz-sim that does the same, with its class as name: "
                    "filename=\"gz-sim-diff-drive-system\" name=\"gz::sim::systems::DiffDrive\" "
                    "for libgazebo_ros_diff_drive.so. Its parameters have other names.",
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::plugin_not_in_gz_sim
