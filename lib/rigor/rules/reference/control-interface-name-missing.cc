// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>

#include <rigor/rules/rule.h>

namespace rigor::rules::control_interface_name_missing {

void look_at(const model::Parameter& component, Context& context) {
  for (const model::Parameter& interface : component.children) {
    const std::string& kind = interface.name;
    if (kind != "command_interface" && kind != "state_interface") continue;
    const auto* name = attribute(interface, "name");
    if (name != nullptr && !name->value.empty()) continue;
    const bool blank = name != nullptr && name->span.size() > 0;
    context.report({.where = blank ? name->span : interface.site.name,
                    .message = "this <" + kind + "> has no name"});
  }
}

void check(const model::Root& root, Context& context) {
  for (const model::Parameter& control : root.ros2_controls) {
    if (!root.own(control.site)) continue;
    for (const model::Parameter& component : control.children) {
      const std::string& kind = component.name;
      if (kind == "joint" || kind == "sensor" || kind == "gpio") look_at(component, context);
    }
  }
}

Rule rule() {
  return {
      .name = "control-interface-name-missing",
      .severity = Severity::kError,
      .formats = Formats::kUrdf,
      .summary = "an interface of ros2_control has no name",
      .why = "ros2_control refuses the whole description when an interface lacks its name: no "
             "attribute 'name' in the tag, it says, and no controller starts.",
      .what_to_do =
          "Name what is commanded or measured: position, velocity, effort, or a name of your own.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::control_interface_name_missing
