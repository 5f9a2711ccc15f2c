// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include <rigor/rules/kinematics/leader.h>
#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::driven_wheel_limited {

constexpr double kEnough = 1000;  // rad; what turns as far is meant to turn on

struct Drive {
  std::string_view library;  // a part of the name of the file
  std::array<std::string_view, 6> joints;
};

constexpr Drive kDrives[] = {
    {"diff-drive", {"left_joint", "right_joint"}},
    {"diff_drive", {"left_joint", "right_joint", "leftJoint", "rightJoint"}},
    {"DiffDrivePlugin", {"left_joint", "right_joint"}},
    {"SkidSteerDrivePlugin", {"left_front", "right_front", "left_rear", "right_rear"}},
    {"skid_steer_drive", {"leftFrontJoint", "rightFrontJoint", "leftRearJoint", "rightRearJoint"}},
    {"mecanum-drive",
     {"front_left_joint", "front_right_joint", "back_left_joint", "back_right_joint"}},
    {"ackermann-steering", {"left_joint", "right_joint"}},
    {"multicopter-motor-model", {"jointName"}},
    {"thruster-system", {"joint_name"}},
};

const Drive* drive_of(const model::Plugin& plugin) {
  for (const Drive& drive : kDrives) {
    if (plugin.filename.value.find(drive.library) != std::string::npos) return &drive;
  }
  return nullptr;
}

/// Why the joint cannot turn on; empty when it can.
std::string obstacle(const model::Joint& joint) {
  if (joint.type != model::JointType::kUnknown && !turns(joint.type)) {
    return fmt::format("is {}", to_string(joint.type));
  }
  if (!is_limited(joint.type) || joint.axes.empty()) return {};
  const model::Axis& axis = joint.axes.front();
  if (!axis.lower.written && !axis.upper.written) return {};  // limit-missing
  if (!(axis.upper.value - axis.lower.value < kEnough)) return {};
  return fmt::format("is limited to {:.6g} … {:.6g} rad", axis.lower.value, axis.upper.value);
}

void check(const model::Plugin& plugin, Context& context) {
  const Drive* drive = drive_of(plugin);
  if (drive == nullptr || !plugin.model) return;
  for (const model::Parameter& given : plugin.parameters) {
    if (std::find(drive->joints.begin(), drive->joints.end(), given.name) == drive->joints.end()) {
      continue;
    }
    const auto id = joint_named(context.frames(), plugin.model, given.value.value);
    if (!id) continue;
    const model::Joint& joint = context.root()[id];
    const std::string why = obstacle(joint);
    if (why.empty()) continue;
    context.report(
        {.where = given.value.span,
         .message = "the plugin turns the joint '" + joint.name.value + "', which " + why,
         .subject = context.subject(plugin)});
  }
}

Rule rule() {
  return {
      .name = "driven-wheel-limited",
      .severity = Severity::kWarning,
      .summary = "a wheel joint that a plugin drives is limited",
      .why = "A wheel or rotor with limits stops when it has reached them, after some meters, and "
             "the robot rotates on the spot or stops; a fixed or sliding one never moves. Wheels, "
             "rotors and propellers rotate without limit.",
      .what_to_do = "Take lower and upper out of the limit of an SDF, or make the joint "
                    "continuous.",
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::driven_wheel_limited
