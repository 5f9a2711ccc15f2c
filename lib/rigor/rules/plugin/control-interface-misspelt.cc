// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules::control_interface_misspelt {

/// Those that controllers and simulators ask for; any other name is an author's own.
constexpr std::array<std::string_view, 4> kStandardNames = {"position", "velocity", "effort",
                                                            "acceleration"};

void look_at(const model::Parameter& interface, Context& context) {
  if (interface.name != "command_interface" && interface.name != "state_interface") return;
  const auto* attribute = model::attribute(interface, "name");
  if (attribute == nullptr) return;
  const std::string_view name = attribute->value;
  for (const std::string_view standard : kStandardNames) {
    if (name.find(standard) != name.npos) return;  // position_x
  }
  const std::vector<std::string_view> names(kStandardNames.begin(), kStandardNames.end());
  const auto near = schema::near(name, names);
  if (near.size() != 1) return;
  const Span where = attribute->span;
  context.report({.where = where,
                  .message = "no controller asks for the interface '" + std::string(name) + "'",
                  .help = "did you mean '" + std::string(near.front()) + "'?",
                  .fix = nearest_instead(name, names, where)});
}

void check(const model::ControlledJoint& controlled, Context& context) {
  if (!controlled.ros2_control) return;
  for (const model::Parameter& interface : controlled.parameters) look_at(interface, context);
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
      .checks = {on<model::ControlledJoint>(check)},
  };
}

}  // namespace rigor::rules::control_interface_misspelt
