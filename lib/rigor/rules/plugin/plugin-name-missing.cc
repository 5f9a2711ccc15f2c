// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/plugin/gazebo_block.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::plugin_name_missing {

void check(const model::Plugin& plugin, Context& context) {
  // In SDF the schema's rules say what is missing.
  const bool given = plugin.name.written && !plugin.name.value.empty();
  if (given || !context.is_urdf()) return;
  context.report({.where = plugin.name.span.size() > 0 ? plugin.name.span : plugin.site.name,
                  .message = "the plugin '" + plugin.filename.value + "' has no name",
                  .subject = context.subject(plugin),
                  .refused = is_read_from_block(plugin, context)});
}

Rule rule() {
  return {
      .name = "plugin-name-missing",
      .severity = Severity::kError,
      .refused = {.urdf = Refusal::kSays},
      .formats = Formats::kUrdf,
      .summary = "a plugin in the <gazebo> of a URDF has no name",
      .why = "libsdformat refuses the whole robot: the name is required (error 4), and must not be "
             "empty. For new Gazebo it is the class that is made.",
      .what_to_do = "Give it a name: for new Gazebo the class, such as "
                    "gz::sim::systems::DiffDrive; for Gazebo classic any.",
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::plugin_name_missing
