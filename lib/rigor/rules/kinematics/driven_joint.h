// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether something in the file drives a joint: a transmission, a command interface of ros2_control, or a
// plugin that names it.
//
//   if (!is_driven(joint, context.root())) return;  // passive: a caster, a roller

#pragma once

#include <algorithm>
#include <string_view>

#include <rigor/model/model.h>

namespace rigor::rules {

/// Whether a value, or a word of a list in it, is the name; names may be scoped.
inline bool names_it(std::string_view value, std::string_view name) {
  constexpr std::string_view kBetween = " \t\r\n,";
  for (std::size_t at = value.find(name); at != value.npos; at = value.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    const bool begins = at == 0 || kBetween.find(value[at - 1]) != kBetween.npos ||
                        value.substr(0, at).ends_with("::");
    const bool ends = end == value.size() || kBetween.find(value[end]) != kBetween.npos;
    if (begins && ends) return true;
  }
  return false;
}

inline bool names_it(const model::Parameters& parameters, std::string_view name) {
  return std::any_of(parameters.begin(), parameters.end(), [name](const auto& one) {
    return names_it(one.value.value, name) || names_it(one.children, name);
  });
}

inline bool is_driven(const model::Joint& joint, const model::Root& root) {
  const std::string& name = joint.name.value;
  if (name.empty()) return false;
  for (const model::ControlledJoint& controlled : root.controlled_joints) {
    const auto commands = [](const auto& one) { return one.name == "command_interface"; };
    const auto& interfaces = controlled.parameters;
    if (controlled.joint.value == name &&
        (!controlled.ros2_control || std::any_of(interfaces.begin(), interfaces.end(), commands)))
      return true;
  }
  return std::any_of(root.plugins.begin(), root.plugins.end(), [&name](const auto& plugin) {
    // Those that tell where joints are move none.
    const std::string& library = plugin.filename.value;
    const bool tells = library.find("state-publisher") != library.npos ||
                       library.find("state_publisher") != library.npos ||
                       library.find("StatePublisher") != library.npos;
    return !tells && names_it(plugin.parameters, name);
  });
}

}  // namespace rigor::rules
