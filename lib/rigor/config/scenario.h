// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A scenario as its author writes it, in TOML: what is done to a model over time, and what is demanded.
// Joints and links are named; SI units only; a key that is not known is a problem.
//
//   schema = 1
//   model  = "model.sdf"                  # from where this file stands
//   [world]
//   gravity = [0, 0, -9.81]
//   ground  = {mu = 1.0}                  # or false
//   [run]
//   time-step = 0.001
//   solver    = "quick"                   # or "dantzig"
//   seeds     = 3
//   [spawn]
//   on-ground = true                      # else as written
//   [joints]
//   left = "left_wheel_hinge"             # names for the commands below
//   [[step]]
//   name  = "settle"
//   until = 1.0
//   [[step]]
//   name  = "drive"
//   until = 5.0
//   commands = [{joint = ["left", "right"], velocity = 10.0, ramp = 1.0}]
//   pushes   = [{link = "chassis", impulse = [0.5, 0, 0], point = [0, 0, 0.1], at = 2.0}]
//   tilt     = {angle = 0.5, axis = [0, 1, 0]}
//   [[assert]]
//   name   = "straight"
//   metric = "drive.lateral"
//   max    = 0.005
//   [[assert]]
//   name     = "distance"
//   position = "chassis"                  # or orientation (roll, pitch, yaw) of a link; or joint = "…"
//   axis     = "x"
//   at       = 5.0
//   min      = 3.45
//   max      = 3.52

#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/config/config.h>

namespace rigor::config {

using Numbers3 = std::array<double, 3>;

enum class CommandKind : std::uint8_t { kEffort, kVelocity, kPosition };

struct ScenarioCommand {
  std::vector<std::string> joints;
  CommandKind kind = CommandKind::kVelocity;
  double value = 0;  ///< N·m, rad/s, rad; of a slider N, m/s, m
  double ramp = 0;   ///< s
  unsigned axis = 0;
  std::optional<Numbers3> gains;  ///< p, i, d of a position
  std::optional<double> effort;   ///< N·m, N at most
};

struct ScenarioPush {
  std::string link;
  Numbers3 impulse{};  ///< N·s
  Numbers3 point{};    ///< m, in the link's frame
  double at = 0;       ///< s
};

struct ScenarioTilt {
  double angle = 0;  ///< rad, reached at the step's end
  Numbers3 axis{0, 1, 0};
};

struct ScenarioStep {
  std::string name;
  double until = 0;  ///< s
  std::vector<ScenarioCommand> commands;
  std::vector<ScenarioPush> pushes;
  std::optional<ScenarioTilt> tilt;
};

struct ScenarioAssert {
  enum class Of : std::uint8_t {
    kMetric,       ///< `name_of` is its id
    kPosition,     ///< of a link, along `axis` x, y or z
    kOrientation,  ///< of a link, about `axis` roll, pitch or yaw
    kJointPosition,
    kJointVelocity,
  };
  std::string name;
  Of of = Of::kMetric;
  std::string name_of;  ///< the metric's, link's or joint's
  unsigned axis = 0;
  std::optional<double> at;  ///< s; the end when not given
  std::optional<double> min;
  std::optional<double> max;
  unsigned line = 0;
};

struct ScenarioFile {
  std::string path;   ///< of the file; empty for a scenario of the command line
  std::string model;  ///< as written; empty when the file names none
  std::optional<Numbers3> gravity;
  bool ground = true;
  std::optional<double> ground_mu;
  std::optional<double> time_step;
  std::optional<std::string> solver;  ///< "quick" or "dantzig"
  std::optional<unsigned> seeds;
  bool on_ground = false;
  std::vector<ScenarioStep> steps;
  std::vector<ScenarioAssert> asserts;
  std::vector<Problem> problems;
};

ScenarioFile read_scenario(const std::string& path, std::string_view bytes);

}  // namespace rigor::config
