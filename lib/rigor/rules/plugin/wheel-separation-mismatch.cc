// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/plugin/drive_wheels.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::wheel_separation_mismatch {

using model::Vector3;

// Wheels have a width, and the point of contact is somewhere in it. Where it is not known, and at most:
constexpr double kMaxOff = 0.12;

// Authors round, and balls have no width.
constexpr double kRounded = 0.03;

// A skid-steered robot turns as if its wheels were farther apart, and authors write that.
constexpr double kMaxSkid = 1.9;

Vector3 mean(const std::vector<DrivenWheel>& wheels, Vector3 DrivenWheel::*point) {
  Vector3 sum;
  for (const DrivenWheel& wheel : wheels) sum = sum + wheel.*point;
  return (1.0 / static_cast<double>(wheels.size())) * sum;
}

/// Along the axle, m; of wheels whose axes are wrong, as the finding about these says, from one to the other.
double distance(const Drive& drive, Vector3 DrivenWheel::*point) {
  constexpr double kAlong = 0.1;
  const Vector3 between = mean(drive.left, point) - mean(drive.right, point);
  const double along = std::abs(dot(between, drive.left.front().axis));
  return along > kAlong * length(between) ? along : length(between);
}

/// Whether the wheels of a side are behind one another; if not, one of them is in a wrong place, and the
/// distance of the sides is none.
bool in_line(const std::vector<DrivenWheel>& wheels, double separation) {
  return std::all_of(wheels.begin(), wheels.end(), [&](const DrivenWheel& wheel) {
    const Vector3 off = wheel.center - wheels.front().center;
    return std::abs(dot(off, wheels.front().axis)) < kMaxOff * separation;
  });
}

/// By how much of the distance of the wheels the separation may be off.
double tolerance(const Drive& drive, double actual) {
  double width = 0;  // m
  for (const auto* side : {&drive.left, &drive.right}) {
    for (const DrivenWheel& wheel : *side) {
      if (!wheel.width) return kMaxOff;
      width = std::max(width, *wheel.width);
    }
  }
  return std::clamp(width / 2 / actual, kRounded, kMaxOff);
}

void check_against(const model::Parameter& parameter, const Drive& drive,
                   const model::Plugin& plugin, Context& context) {
  const auto written = positive_number(parameter);
  if (!written) return;
  const double of_wheels = distance(drive, &DrivenWheel::center);
  const double of_joints = distance(drive, &DrivenWheel::position);
  if (!(of_wheels > 0) || !(of_joints > 0)) return;
  const bool skids = drive.left.size() > 1;
  for (const double actual : {of_wheels, of_joints}) {
    const double off = skids ? kMaxOff : tolerance(drive, actual);
    if (*written > actual * (1 - off) && *written < actual * (skids ? kMaxSkid : 1 + off)) return;
  }
  const Span where = trimmed(parameter, context);
  const std::string right = value_with_digits(*written, of_wheels);
  context.report({.where = where,
                  .message = fmt::format(
                      "the plugin's wheel separation is {:.6g} m, and the wheels are {} m apart",
                      *written, right),
                  .subject = context.subject(plugin),
                  .help = fmt::format("write {}", right),
                  .fix = Fix{"write their distance", Applicability::kUnsafe, {{where, right}}}});
}

void check(const model::Plugin& plugin, Context& context) {
  const auto drive = drive_of(plugin, context);
  if (!drive) return;
  const double separation = distance(*drive, &DrivenWheel::center);
  if (!in_line(drive->left, separation) || !in_line(drive->right, separation)) return;
  for (const model::Parameter* parameter : drive->separations) {
    check_against(*parameter, *drive, plugin, context);
  }
}

Rule rule() {
  return {
      .name = "wheel-separation-mismatch",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a drive plugin's wheel separation is not that of the wheels",
      .why = "The robot turns by another angle than commanded, and reports the commanded "
             "angle: odometry and map drift apart with each turn. The plugin computes the speeds "
             "of its wheels from the separation, not from the geometry.",
      .what_to_do =
          "Write the distance of the wheels' centers along the axle, in meters; half of a "
          "tread's width more or less is taken as meant. Of a "
          "robot with several wheels on a side up to 1.9 times that is taken for the "
          "effective separation of a skid-steered one.",
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::wheel_separation_mismatch
