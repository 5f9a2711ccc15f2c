// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/core.h>

#include <rigor/rules/plugin/drive_wheels.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::drive_wheels_inconsistent {

// 60°: no camber, toe or mecanum roller comes near.
constexpr double kAcross = 0.5;

constexpr double kVertical = 0.9;  // cosine

// m; wheels of one side are apart by more than what rounding makes of poses.
constexpr double kApart = 1e-3;

std::string name_of(const DrivenWheel& wheel, const Context& context) {
  return "'" + context.root()[wheel.joint].name.value + "'";
}

void report(const DrivenWheel& wheel, std::string message, const model::Plugin& plugin,
            Context& context) {
  context.report({.where = trimmed(*wheel.named, context),
                  .message = std::move(message),
                  .subject = context.subject(plugin)});
}

/// Whether one of them was reported.
bool check_pair(const DrivenWheel& left, const DrivenWheel& right, const model::Plugin& plugin,
                Context& context) {
  if (left.joint == right.joint) {
    report(left, fmt::format("the joint {} is on both sides of the drive", name_of(left, context)),
           plugin, context);
    return true;
  }
  const double cosine = dot(left.axis, right.axis);
  if (std::abs(cosine) < kAcross) {
    report(left,
           fmt::format(
               "the axes of the driven joints {} and {} are {:.0f}° apart: one is not a wheel's",
               name_of(left, context), name_of(right, context),
               std::acos(std::abs(cosine)) * 57.29577951308232),
           plugin, context);
    return true;
  }
  if (cosine < 0) {
    report(right,
           fmt::format(
               "the axes of {} and {} are opposed: commanded straight ahead, the robot rotates",
               name_of(left, context), name_of(right, context)),
           plugin, context);
    return true;
  }
  const bool flat = std::min(std::abs(left.axis.z), std::abs(right.axis.z)) > kVertical;
  if (flat && !left.across && !right.across) {
    report(left,
           fmt::format("the axes of {} and {} are vertical: the wheels lie flat, and do not roll",
                       name_of(left, context), name_of(right, context)),
           plugin, context);
    return true;
  }
  if (dot(left.center - right.center, left.axis) < -kApart) {
    report(
        left,
        fmt::format("the left wheel {} is on the right of {} as their axes rotate: the robot turns "
                    "the wrong way",
                    name_of(left, context), name_of(right, context)),
        plugin, context);
    return true;
  }
  return false;
}

/// Whether they were reported: a plugin commands both to angles of one sign.
bool check_steering(const Drive& drive, const model::Plugin& plugin, Context& context) {
  if (drive.left_steering.empty() || drive.right_steering.empty()) return false;
  const DrivenWheel& left = drive.left_steering.front();
  const DrivenWheel& right = drive.right_steering.front();
  if (dot(left.axis, right.axis) > -kAcross) return false;
  report(right,
         fmt::format("the axes of {} and {} are opposed: told to turn left, one wheel steers right",
                     name_of(left, context), name_of(right, context)),
         plugin, context);
  return true;
}

/// What only has a left and a right joint may be a gripper.
bool is_drive(const Drive& drive, const model::Plugin& plugin) {
  if (!drive.separations.empty() || !drive.radii.empty() || !drive.diameters.empty()) return true;
  const std::string& file = plugin.filename.value;
  return file.find("drive") != std::string::npos || file.find("Drive") != std::string::npos;
}

void check(const model::Plugin& plugin, Context& context) {
  const auto drive = drive_of(plugin, context);
  if (!drive || !is_drive(*drive, plugin)) return;
  if (check_steering(*drive, plugin, context)) return;
  for (const DrivenWheel& left : drive->left) {
    for (const DrivenWheel& right : drive->right) {
      if (check_pair(left, right, plugin, context)) return;
    }
  }
}

Rule rule() {
  return {
      .name = "drive-wheels-inconsistent",
      .severity = Severity::kWarning,
      .summary = "the wheels of a drive plugin are exchanged, opposed, flat or not of one axle",
      .why = "The robot rotates when it should drive, or turns left when it should turn right, "
             "and its odometry says otherwise. To go forward a drive turns the joints of both "
             "sides at the same positive speed, and a positive rotation about an axis that points "
             "to the left rolls forward.",
      .what_to_do = "Exchange the joints, negate an axis, or name the wheel's own joint.",
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::drive_wheels_inconsistent
