// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>

#include <rigor/read/values.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::control_interface_name_missing {

void look_at(xml::Element component, Context& context) {
  for (const xml::Element interface : component.children()) {
    const std::string_view kind = interface.name();
    if (kind != "command_interface" && kind != "state_interface") continue;
    const auto name = interface.attribute("name");
    if (name && !read::trimmed(name->value()).empty()) continue;
    context.report({.where = name && name->value_span().size() > 0 ? name->value_span()
                                                                   : interface.name_span(),
                    .message = "this <" + std::string(kind) + "> has no name"});
  }
}

void check(const model::Root& root, Context& context) {
  const auto robot = context.document().root();
  if (!robot || root.format != model::Format::kUrdf) return;
  for (const xml::Element control : robot->children()) {
    if (control.name() != "ros2_control") continue;
    for (const xml::Element component : control.children()) {
      const std::string_view kind = component.name();
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
