// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/plugin/gazebo_block.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::plugin_filename_missing {

void check(const model::Plugin& plugin, Context& context) {
  const auto& file = plugin.filename;
  // The schema's rules name an attribute that SDF misses; what is in the <gazebo> of a URDF they do not see.
  if (!file.value.empty() || (context.is_sdf() && !file.written)) return;
  context.report({.where = file.span.size() > 0 ? file.span : plugin.site.name,
                  .message = "the plugin '" + plugin.name.value + "' names no library",
                  .subject = context.subject(plugin),
                  .refused = is_read_from_block(plugin, context)});
}

Rule rule() {
  return {
      .name = "plugin-filename-missing",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways, .urdf = Refusal::kSays},
      .summary = "a plugin names no library",
      .why = "libsdformat refuses the file, also one that it makes of a URDF: the filename is "
             "required, and must not be empty.",
      .what_to_do = "Name the library, such as gz-sim-diff-drive-system, or take the plugin out.",
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::plugin_filename_missing
