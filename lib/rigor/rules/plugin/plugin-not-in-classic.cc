// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/plugin/simulator.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::plugin_not_in_classic {

void check(const model::Plugin& plugin, Context& context) {
  const std::string& library = plugin.filename.value;
  if (!is_of_new_gazebo(library)) return;
  context.report(
      {.where = plugin.filename.span,
       .message = "'" + library + "' is a system of gz-sim: Gazebo classic cannot load it",
       .subject = context.subject(plugin)});
}

Rule rule() {
  return {
      .name = "plugin-not-in-classic",
      .severity = Severity::kWarning,
      .targets = {Target::kGazeboClassic},
      .summary = "a system of gz-sim in a model for Gazebo classic",
      .why = "Gazebo classic loads libraries of its own kind only. It says that it cannot load "
             "this one, and goes on without what it would do.",
      .what_to_do = "Keep a file for each simulator, or use the plugin of Gazebo classic that does "
                    "the same, such as libDiffDrivePlugin.so for gz-sim-diff-drive-system.",
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::plugin_not_in_classic
