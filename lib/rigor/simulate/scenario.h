// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is done to a scene over time, and what is demanded of it: phases, commands with ramps, pushes,
// a table that tilts. The tests of `simulate` are scenarios (simulate/test/tests.h); a user writes others in a file
// (scenario_file.h).
//
//   Scenario drive{.name = "drive", .duration = 5, .phases = {{"settle", 0, 1}, {"drive", 1, 5}}};
//   drive.commands.push_back({.joint = 0, .kind = CommandKind::kVelocity, .value = 10, .begin = 1,
//                             .end = 5, .ramp = 1});

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

enum class CommandKind : std::uint8_t { kEffort, kVelocity, kPosition };

/// How a controller works: a real one sees where the joint was a step ago, and is unstable beyond a gain; one
/// that is solved together with the motion is stable with any, as a spring is.
enum class Control : std::uint8_t { kExplicit, kImplicit };

/// Of a position command. Per rad (or m) of error, of its integral, of its rate.
struct Gains {
  double p = 0;
  double i = 0;
  double d = 0;
};

/// An axis is given an effort (N·m, N), a velocity (rad/s, m/s) or a position (rad, m). The value rises
/// linearly from the one before (zero, or where the axis stands) over `ramp` seconds.
struct Command {
  std::uint32_t joint = 0;  ///< index in the scene
  std::uint32_t axis = 0;
  CommandKind kind = CommandKind::kVelocity;
  double value = 0;
  double begin = 0;  ///< s
  double end = 0;    ///< s; then the axis is free again
  double ramp = 0;   ///< s
  /// None: a position is reached by a motor, as exactly as the joint's effort allows.
  std::optional<Gains> gains;
  Control control = Control::kExplicit;  ///< of gains; an implicit controller has no `i`
  double effort = kInfinity;             ///< N·m, N; the axis' own limit holds too
};

/// At a moment, N·s in W at a point of the body.
struct Push {
  std::uint32_t body = 0;
  Vector3 impulse_W;
  Vector3 p_BP;
  double at = 0;
};

/// Gravity turns about a horizontal axis from upright to `angle`, as if the ground were a table.
struct Tilt {
  double begin = 0;
  double end = 0;
  double angle = 0;  ///< rad
  Vector3 axis{0, 1, 0};
};

/// A span of time that metrics refer to.
struct Phase {
  std::string name;
  double begin = 0;
  double end = 0;
};

enum class Spawn : std::uint8_t {
  kOnGround,  ///< each model that moves is set down: its lowest point touches the ground
  kAsWritten,
};

/// What keeps a model up that nothing holds: the ground alone, the world that its base is bolted to where it
/// stands, or the same without any ground.
enum class Base : std::uint8_t { kFree, kFixed, kHang };

/// `metric` of the run, or a pose or joint at a time, lies between two numbers.
struct Assertion {
  std::string name;
  std::string metric;    ///< an id; or
  std::string quantity;  ///< "x|y|z|roll|pitch|yaw of LINK", "position|velocity of JOINT"
  double at = 0;         ///< s, of a quantity; the end when infinite
  double least = -kInfinity;
  double most = kInfinity;
};

struct Scenario {
  std::string name;
  double duration = 1;  ///< s
  std::vector<Phase> phases;
  std::vector<Command> commands;
  std::vector<Push> pushes;
  std::vector<Tilt> tilts;
  std::vector<Assertion> assertions;
  Spawn spawn = Spawn::kAsWritten;
  double drop = 0;  ///< m above where it is spawned
  Base base = Base::kFree;
  bool gravity = true;
  bool ground = true;  ///< of a file with a model at the top, where the scene has none of its own
  double ground_mu = 1;
  // In place of what the scene says.
  std::optional<Vector3> gravity_W;  ///< m/s²
  std::optional<double> step;        ///< s
  std::optional<Solver> solver;
};

/// The settings that a scenario is run with.
inline SolverSettings settings_in(const Scenario& scenario, SolverSettings settings) {
  if (scenario.step) settings.step = *scenario.step;
  if (scenario.solver) settings.solver = *scenario.solver;
  return settings;
}

}  // namespace rigor::simulate
