// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/read/values.h>
#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules::control_interface_misspelt {

/// Those that controllers and simulators ask for; any other name is an author's own.
constexpr std::array<std::string_view, 4> kStandardNames = {"position", "velocity", "effort",
                                                            "acceleration"};

void look_at(xml::Element interface, Context& context) {
  const std::string_view kind = interface.name();
  if (kind != "command_interface" && kind != "state_interface") return;
  const auto attribute = interface.attribute("name");
  if (!attribute) return;
  const std::string_view name = read::trimmed(attribute->value());
  for (const std::string_view standard : kStandardNames) {
    if (name.find(standard) != name.npos) return;  // position_x
  }
  const std::vector<std::string_view> names(kStandardNames.begin(), kStandardNames.end());
  const auto near = schema::near(name, names);
  if (near.size() != 1) return;
  const Span where = attribute->value_span();
  context.report({.where = where,
                  .message = "no controller asks for the interface '" + std::string(name) + "'",
                  .help = "did you mean '" + std::string(near.front()) + "'?",
                  .fix = nearest_instead(name, names, where)});
}

void check(const model::Root& /*root*/, Context& context) {
  const auto robot = context.document().root();
  if (!robot) return;
  for (const xml::Element control : robot->children()) {
    if (control.name() != "ros2_control") continue;
    for (const xml::Element component : control.children()) {
      if (component.name() != "joint") continue;
      for (const xml::Element interface : component.children()) look_at(interface, context);
    }
  }
}

Rule rule() {
  return {
      .name = "control-interface-misspelt",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .fix = FixGrade::kUnsafe,
      .summary = "the name of an interface of ros2_control is nearly a standard one",
      .why = "ros2_control takes any name. A controller that asks for 'position' does not find "
             "'positon' and does not start, and Gazebo gives the joint no such interface.",
      .what_to_do = "Write position, velocity, effort or acceleration.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::control_interface_misspelt
