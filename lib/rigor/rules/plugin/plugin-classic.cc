// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <string>

#include <rigor/rules/plugin/simulator.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::plugin_classic {

// Gazebo classic ends with SDF 1.7, so a file of a later version is not for it.
constexpr int kFirstWithoutClassic = 8;

/// Whether the world itself loads systems of new Gazebo.
bool is_world_of_new_gazebo(const model::Root& root) {
  return std::any_of(root.plugins.begin(), root.plugins.end(), [](const model::Plugin& plugin) {
    return plugin.world && is_of_new_gazebo(plugin.filename.value);
  });
}

void check(const model::Plugin& plugin, Context& context) {
  const std::string& file = plugin.filename.value;
  if (!is_of_gazebo_classic(file)) return;
  if (context.root().version < kFirstWithoutClassic) {
    const bool has_class = plugin.name.value.find("::systems::") != std::string::npos;
    if (!has_class && !is_world_of_new_gazebo(context.root())) return;
    context.report({.where = plugin.filename.span,
                    .message = "'" + file + "' is a plugin of Gazebo classic, and " +
                               (has_class ? "'" + plugin.name.value + "' a class of Gazebo Sim"
                                          : "the world loads systems of Gazebo Sim"),
                    .subject = context.subject(plugin)});
    return;
  }
  context.report({.where = plugin.filename.span,
                  .message = "'" + file +
                             "' is a plugin of Gazebo classic, which does not read SDF " +
                             context.root().version_text.value,
                  .subject = context.subject(plugin)});
}

Rule rule() {
  return {
      .name = "plugin-classic",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "a plugin of Gazebo classic in a file that is not for it",
      .why = "Gazebo Sim cannot load it: it logs an error at the start and continues without it. "
             "Gazebo classic reads SDF up to 1.7.",
      .what_to_do = "Use the system of new Gazebo that does the same, such as "
                    "gz-sim-diff-drive-system for libgazebo_ros_diff_drive.so.",
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::plugin_classic
