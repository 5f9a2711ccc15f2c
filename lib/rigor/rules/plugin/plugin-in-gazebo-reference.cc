// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>

namespace rigor::rules::plugin_in_gazebo_reference {

void check(const model::Plugin& plugin, Context& context) {
  if (plugin.gazebo_reference.empty() || plugin.sensor || plugin.filename.value.empty()) return;
  context.report(
      {.where = plugin.site.name,
       .message = fmt::format("the plugin is in <gazebo reference=\"{}\">, where none is loaded",
                              plugin.gazebo_reference),
       .subject = context.subject(plugin)});
}

Rule rule() {
  return {
      .name = "plugin-in-gazebo-reference",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .summary = "a model's plugin is in the block of a link or joint",
      .why = "libsdformat puts what is in <gazebo reference=\"…\"> into that link or joint, and "
             "Gazebo loads plugins of models, sensors and worlds only: this one is left out, "
             "without a message.",
      .what_to_do = "Put it into a <gazebo> without reference. The plugin of a sensor belongs into "
                    "its <sensor>.",
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::plugin_in_gazebo_reference
