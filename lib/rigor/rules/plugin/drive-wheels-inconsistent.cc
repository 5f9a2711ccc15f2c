// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <fmt/core.h>

#include <rigor/robot/assembled/assembled.h>
#include <rigor/rules/kinematics/leader.h>
#include <rigor/rules/plugin/drive_wheels.h>
#include <rigor/rules/rule.h>
#include <rigor/write/numbers.h>

namespace rigor::rules::drive_wheels_inconsistent {

// 60°: no camber, toe or mecanum roller comes near.
constexpr double kAcross = 0.5;

constexpr double kVertical = 0.9;  // cosine
constexpr double kSideways = 0.9;  // cosine

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

const model::Axis& axis_of(const DrivenWheel& wheel, const Context& context) {
  return context.root()[wheel.joint].axes.front();
}

/// The axis as it has to be written to point the other way; nothing where it is not in this file.
std::optional<std::string> opposite(const DrivenWheel& wheel, const Context& context) {
  const model::Joint& joint = context.root()[wheel.joint];
  const model::Axis& axis = axis_of(wheel, context);
  if (!context.root().own(joint.site) || !axis.xyz.written) return std::nullopt;
  const auto written = write::numbers_in(context.bytes(axis.xyz.span));
  if (!written || written->size() != 3) return std::nullopt;
  const auto negated = [&](std::size_t k) { return (*written)[k] == 0 ? 0.0 : -(*written)[k]; };
  return write::joined({negated(0), negated(1), negated(2)});
}

/// How far a wheel is to the left of another, and its axis points there, in the frame of their model, whose x is
/// forward and whose y is left. Nothing where the model drives along another axis.
struct Sideways {
  double apart = 0;  ///< m
  bool axis_left = false;
};

std::optional<Sideways> sideways(const DrivenWheel& left, const DrivenWheel& right,
                                 Context& context) {
  const auto X_WM = context.frames().pose(context.root()[left.joint].model);
  if (!X_WM) return std::nullopt;
  const auto in_M = [&](const model::Vector3& v) { return rotate(conjugate(X_WM->rotation), v); };
  const double along = in_M(left.axis).y;
  if (std::abs(along) < kSideways) return std::nullopt;
  return Sideways{in_M(left.center - right.center).y, along > 0};
}

/// Both wheels are where their names say, and turn backwards. False where the axes cannot be the mistake.
bool report_backwards(const DrivenWheel& left, const DrivenWheel& right, Context& context) {
  const auto side = sideways(left, right, context);
  if (!side || side->axis_left || side->apart < kApart) return false;
  const auto of_left = opposite(left, context), of_right = opposite(right, context);
  if (!of_left || !of_right) return false;
  const Span where = axis_of(left, context).xyz.span, other = axis_of(right, context).xyz.span;
  Fix fix{"turn both axes around", Applicability::kUnsafe, {{where, *of_left}}};
  if (other != where) fix.edits.push_back({other, *of_right});
  context.report({.where = where,
                  .message = fmt::format("the axes of the wheels {} and {} both point to -y: the "
                                         "robot drives backwards and turns the wrong way",
                                         name_of(left, context), name_of(right, context)),
                  .subject = context.subject(context.root()[left.joint]),
                  .related = {{other, "the axis of the other wheel"},
                              {trimmed(*left.named, context), "the plugin's left wheel"}},
                  .help = *of_left == *of_right
                              ? fmt::format("write `{}` in both joints", *of_left)
                              : fmt::format("write `{}` and `{}`", *of_left, *of_right),
                  .fix = std::move(fix)});
  return true;
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
    if (report_backwards(left, right, context)) return true;
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

using JointSet = std::set<model::Id<model::Joint>>;

/// Those that ros2_control turns at a speed, which no plugin names.
JointSet joints_of_velocity_commands(Context& context) {
  JointSet result;
  for (const model::ControlledJoint& controlled : context.root().controlled_joints) {
    const bool at_speed = std::any_of(
        controlled.parameters.begin(), controlled.parameters.end(), [](const auto& interface) {
          const auto* name = model::attribute(interface, "name");
          return interface.name == "command_interface" && name && name->value == "velocity";
        });
    if (!controlled.ros2_control || !at_speed) continue;
    const auto id = joint_named(context.frames(), {0}, controlled.joint.value);
    if (id && context.root()[id].type == model::JointType::kContinuous) result.insert(id);
  }
  return result;
}

/// Whether they face each other on one axle, and their axes are opposed.
bool are_opposed(const DrivenWheel& left, const DrivenWheel& right) {
  const model::Vector3 between = left.center - right.center;
  return dot(left.axis, right.axis) < -kSideways && length(between) > kApart &&
         std::abs(dot(between, left.axis)) > kSideways * length(between);
}

void report_opposed(const DrivenWheel& left, const DrivenWheel& right, Context& context) {
  const auto side = sideways(left, right, context);
  if (!side) return;
  const DrivenWheel& wrong = side->axis_left ? right : left;
  const DrivenWheel& good = side->axis_left ? left : right;
  const model::Joint& joint = context.root()[wrong.joint];
  const Span where = joint.axes.front().xyz.span;
  const auto text = opposite(wrong, context);
  context.report(
      {.where = text ? where : joint.site.name,
       .message = fmt::format(
           "the axis of {} points to -y and that of {} to +y: commanded straight ahead, the robot "
           "rotates",
           name_of(wrong, context), name_of(good, context)),
       .subject = context.subject(joint),
       .related = {{axis_of(good, context).xyz.span, "the axis of the other wheel"}},
       .help = text ? fmt::format("write `{}`", *text) : "",
       .fix = text && where != axis_of(good, context).xyz.span
                  ? std::optional(
                        Fix{"turn the axis around", Applicability::kUnsafe, {{where, *text}}})
                  : std::nullopt});
}

/// Wheels of ros2_control: which of them are a controller's left and right ones, only their names tell.
void check_claimed(const model::Root& root, Context& context) {
  const JointSet claimed = joints_of_velocity_commands(context);
  if (claimed.size() < 2) return;
  for (const model::Plugin& plugin : root.plugins) {
    const auto drive = drive_of(plugin, context);
    if (drive && is_drive(*drive, plugin)) return;
  }
  for (const robot::Twins& pair : context.assembled().joint_twins) {
    if (!claimed.contains({pair.a}) || !claimed.contains({pair.b})) continue;
    const auto left = wheel_of({pair.a}, context), right = wheel_of({pair.b}, context);
    if (!left || !right || left->radii.empty() || right->radii.empty()) continue;
    if (are_opposed(*left, *right)) report_opposed(*left, *right, context);
  }
}

Rule rule() {
  return {
      .name = "drive-wheels-inconsistent",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "the wheels of a drive are exchanged, opposed, backwards, flat or not of one axle",
      .why = "The robot rotates when it should drive, or turns left when it should turn right, "
             "and its odometry says otherwise. To go forward a drive turns the joints of both "
             "sides at the same positive speed, and a positive rotation about an axis that points "
             "to the left rolls forward. Without a drive plugin a left and a right wheel that "
             "ros2_control turns are checked for opposed axes.",
      .what_to_do = "Exchange the joints, negate an axis, or name the wheel's own joint.",
      .checks = {on<model::Plugin>(check), on<model::Root>(check_claimed)},
  };
}

}  // namespace rigor::rules::drive_wheels_inconsistent
