// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/rules/xml/xacro.h>

namespace rigor::rules::hardware_plugin_missing {

void check(const model::Root& root, Context& context) {
  for (const model::Parameter& control : root.ros2_controls) {
    if (!root.own(control.site) || has_xacro_child(control)) continue;
    const auto* hardware = find(control.children, "hardware");
    if (hardware != nullptr && has_xacro_child(*hardware)) continue;
    const auto* plugin = hardware != nullptr ? find(hardware->children, "plugin") : nullptr;
    if (plugin != nullptr && !plugin->value.value.empty()) continue;
    const auto& lacking = plugin != nullptr ? *plugin : hardware != nullptr ? *hardware : control;
    context.report({.where = lacking.site.name,
                    .message = plugin ? "this <plugin> names no hardware interface"
                               : hardware
                                   ? "this <hardware> has no <plugin>"
                                   : "this <ros2_control> has no <hardware> with a <plugin>"});
  }
}

Rule rule() {
  return {
      .name = "hardware-plugin-missing",
      .severity = Severity::kError,
      .formats = Formats::kUrdf,
      .summary = "a ros2_control block does not say what drives the hardware",
      .why =
          "ros2_control's parser throws on a <hardware> without the text of a <plugin>, and the "
          "controller manager does not start. Without a <hardware> there is no component to load.",
      .what_to_do =
          "Name the class: <hardware><plugin>mock_components/GenericSystem</plugin></hardware> "
          "without hardware, gz_ros2_control/GazeboSimSystem in gz-sim.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::hardware_plugin_missing
