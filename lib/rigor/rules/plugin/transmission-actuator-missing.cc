// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/rule.h>

namespace rigor::rules::transmission_actuator_missing {

void check(const model::Root& root, Context& context) {
  for (const model::Parameter& transmission : root.transmissions) {
    if (!root.own(transmission.site) || find(transmission.children, "joint") == nullptr) continue;
    // What PR2's controllers read, and what names a plugin as a whole.
    const auto* type = model::attribute(transmission, "type");
    if (type != nullptr || find(transmission.children, "plugin") != nullptr) continue;
    if (find(transmission.children, "type") == nullptr) continue;
    if (find(transmission.children, "actuator") != nullptr) continue;
    const auto* name = model::attribute(transmission, "name");
    context.report({.where = transmission.site.name,
                    .message = "the transmission" +
                               (name != nullptr ? " '" + name->value + "'" : std::string()) +
                               " has no <actuator>"});
  }
}

Rule rule() {
  return {
      .name = "transmission-actuator-missing",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .summary = "a transmission has no actuator",
      .why = "ros_control and gazebo_ros_control do not load it (\"No actuators in "
             "transmission\"): the joint gets no hardware interface, and no controller finds it.",
      .what_to_do = "Add <actuator name=\"…\"> with its <mechanicalReduction>.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::transmission_actuator_missing
