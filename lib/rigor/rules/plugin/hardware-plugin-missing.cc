// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>

#include <rigor/read/values.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/xml/xacro.h>

namespace rigor::rules::hardware_plugin_missing {

void check(const model::Root& /*root*/, Context& context) {
  const auto robot = context.document().root();
  if (!robot) return;
  for (const xml::Element control : robot->children()) {
    if (control.name() != "ros2_control" || has_xacro_child(control)) continue;
    const auto hardware = control.child("hardware");
    if (hardware && has_xacro_child(*hardware)) continue;
    const auto plugin = hardware ? hardware->child("plugin") : std::nullopt;
    if (plugin && !read::trimmed(plugin->text()).empty()) continue;
    const Span where = plugin     ? plugin->name_span()
                       : hardware ? hardware->name_span()
                                  : control.name_span();
    context.report({.where = where,
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
