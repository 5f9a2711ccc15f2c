// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <string>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/kinematics/leader.h>
#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>
#include <rigor/write/numbers.h>

namespace rigor::rules::initial_position_outside_limits {

constexpr double kTolerance = 1e-6;

void check_value(const model::Field<std::string>& value, model::Id<model::Joint> id,
                 Context& context) {
  if (!id) return;
  const model::Joint& joint = context.root()[id];
  if (!is_limited(joint.type) || joint.axes.empty()) return;
  const model::Axis& axis = joint.axes.front();
  const auto position = write::number_in(value.value);
  if (!position || axis.lower.value > axis.upper.value) return;
  if (*position >= axis.lower.value - kTolerance && *position <= axis.upper.value + kTolerance) {
    return;
  }
  context.report({.where = value.span,
                  .message = fmt::format("the joint '{}' is to begin at {:.6g} {}, but its limits "
                                         "are {:.6g} and {:.6g}",
                                         joint.name.value, *position, position_unit(joint.type),
                                         axis.lower.value, axis.upper.value)});
}

/// Of the n-th joint the n-th position; of a position controller the only one is for all.
void check_plugin(const model::Plugin& plugin, Context& context) {
  const bool trajectory =
      plugin.filename.value.find("joint-trajectory-controller") != std::string::npos;
  if (!trajectory && plugin.filename.value.find("joint-position-controller") == std::string::npos) {
    return;
  }
  std::vector<model::Field<std::string>> names;
  std::vector<model::Field<std::string>> positions;
  for (const model::Parameter& given : plugin.parameters) {
    if (given.name == "joint_name") names.push_back(given.value);
    if (given.name == "initial_position") positions.push_back(given.value);
  }
  if (positions.empty()) return;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (trajectory && i >= positions.size()) return;
    check_value(trajectory ? positions[i] : positions.front(),
                joint_named(context.frames(), plugin.model, names[i].value), context);
  }
}

void check_plugins(const model::Root& root, Context& context) {
  for (const model::Plugin& plugin : root.plugins) {
    if (plugin.model && root.own(plugin.site)) check_plugin(plugin, context);
  }
}

void check_ros2_control(const model::Root& root, Context& context) {
  for (const model::ControlledJoint& controlled : root.controlled_joints) {
    if (!controlled.ros2_control || root.models.empty() || !root.own(controlled.site)) continue;
    const auto id = joint_named(context.frames(), {0}, controlled.joint.value);
    for (const model::Parameter& face : controlled.parameters) {
      const auto* of = attribute(face, "name");
      if (face.name != "state_interface" || of == nullptr || of->value != "position") continue;
      for (const model::Parameter& parameter : face.children) {
        const auto* name = attribute(parameter, "name");
        if (name != nullptr && name->value == "initial_value") {
          check_value(parameter.value, id, context);
        }
      }
    }
  }
}

Rule rule() {
  return {
      .name = "initial-position-outside-limits",
      .severity = Severity::kWarning,
      .summary = "a joint is to begin outside its limits",
      .why = "The controller aims at a place that the joint cannot reach: it pushes against the "
             "stop for ever. Most often the number is in degrees or millimetres, or the limits "
             "were changed later.",
      .what_to_do = "Write a position between the limits, in radians or metres.",
      .checks = {on<model::Root>(check_plugins), on<model::Root>(check_ros2_control)},
  };
}

}  // namespace rigor::rules::initial_position_outside_limits
