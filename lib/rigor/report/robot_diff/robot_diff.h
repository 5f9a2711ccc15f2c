// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What differs between two models, for who reviews the change: a line for each thing that differs, from
// what to what, with units.
//
//   std::fputs(robot_diff_text({a, b, differences, sources}).c_str(), stdout);

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <rigor/robot/compare.h>
#include <rigor/text/sources.h>

namespace rigor::report {

/// One of the two.
struct DiffSide {
  std::string path;
  const robot::Robot& robot;
};

struct RobotDiff {
  DiffSide a, b;
  const std::vector<robot::Difference>& differences;
  const Sources& sources;
  std::string_view not_compared = {};  ///< what the models have beside; empty: nothing (settings.h)
};

/// What is compared only between models of one format.
inline constexpr const char* kSettingsInWords =
    "contact, gravity, self-collision, sensors, lights and plugins";
/// The same, with what only `rigor diff` compares.
inline constexpr const char* kAllSettingsInWords =
    "contact, gravity, self-collision, soft limits, armature, sensors, lights, plugins, "
    "transmissions, ros2_control and the world around the model";
/// What of two MJCF files is not compared.
inline constexpr const char* kMjcfSettingsInWords =
    "contact but for the friction of geoms, gravity, actuators, tendons, sensors, lights and "
    "plugins";

/// Empty when nothing differs.
std::string robot_diff_text(const RobotDiff& diff);

/// Lengths in m, angles in rad; infinite numbers are null. Positions as in the other reports.
std::string robot_diff_json(const RobotDiff& diff);

/// "joint elbow moved by 1 mm", in words, without where.
std::string in_words(const robot::Difference& difference);

}  // namespace rigor::report
