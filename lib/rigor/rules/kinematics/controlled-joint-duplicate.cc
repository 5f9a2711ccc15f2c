// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <rigor/rules/rule.h>

namespace rigor::rules::controlled_joint_duplicate {

/// "elbow position", for each interface that moves it.
std::vector<std::string> commands_of(const model::ControlledJoint& controlled) {
  const char* kind = controlled.ros2_control ? "command_interface" : "hardwareInterface";
  std::vector<std::string> commands;
  for (const model::Parameter& given : controlled.parameters) {
    if (given.name != kind) continue;
    const auto* name = controlled.ros2_control ? attribute(given, "name") : &given.value;
    const std::string command = name != nullptr ? name->value : std::string();
    commands.push_back(kind + (' ' + controlled.joint.value) + ' ' + command);
  }
  return commands;
}

void check(const model::Root& root, Context& context) {
  std::unordered_map<std::string, Span> first;
  for (const model::ControlledJoint& controlled : root.controlled_joints) {
    if (controlled.joint.value.empty() || !root.own(controlled.site)) continue;
    bool reported = false;
    for (std::string& command : commands_of(controlled)) {
      const auto [known, is_new] = first.emplace(std::move(command), controlled.joint.span);
      if (is_new || reported || known->second == controlled.joint.span) continue;
      reported = true;
      context.report({.where = controlled.joint.span,
                      .message = "the joint '" + controlled.joint.value +
                                 "' is driven a second time, by the same interface",
                      .related = {{known->second, "the first time"}}});
    }
  }
}

Rule rule() {
  return {
      .name = "controlled-joint-duplicate",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .summary = "a joint has two command interfaces of the same kind",
      .why = "Where two entries offer the same command, it is undefined which motor a controller "
             "moves. A command has one owner; most often one of them was copied and should name "
             "another joint.",
      .what_to_do = "Let one block drive the joint.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::controlled_joint_duplicate
