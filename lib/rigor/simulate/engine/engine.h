// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A scene in ODE, one step at a time. Only for a process of its own: ODE has globals, and reports
// what it does not like by handlers that are set for the whole process; here they throw EngineError.
//
//   Engine engine(scene, settings);
//   engine.set_effort(joint, axis, 2.0);
//   engine.step();
//   watch.see(engine.state());
//
// ODE: R. Smith, "Open Dynamics Engine User Guide", 2006, and its 0.16 sources. How SDF's words become
// ODE's follows Gazebo 11 where its sources were read (docs/simulate.md has the table).

#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>

#include <rigor/simulate/engine/state.h>
#include <rigor/simulate/scenario.h>
#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

/// What ODE said before it would have ended the process. The engine is of no use after it, save that
/// `state()` tells where bodies were left; nor is ODE in this process when it came from a step.
class EngineError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A spring and a damper that pull an axis to where it is commanded to be.
struct Servo {
  double stiffness = 0;  ///< N·m/rad, N/m
  double damping = 0;    ///< N·m·s/rad, N·s/m
  double error = 0;      ///< rad, m: how far it is to go
  double rate = 0;       ///< rad/s, m/s: how fast the place moves
  double effort = kInfinity;
};

/// Whether contacts' forces are asked for: they cost a little.
enum class Forces : std::uint8_t { kNone, kAsked };

class Engine {
 public:
  /// The scene must outlive it. An EngineError in a build without ODE.
  Engine(const Scene& scene, const SolverSettings& settings);
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// For the coming steps, until commanded otherwise; `effort` is cut at the axis' limit. A motor reaches
  /// the velocity with at most `effort`, and takes the place of the axis' friction meanwhile.
  void set_effort(std::uint32_t joint, std::uint32_t axis, double effort);
  void set_motor(std::uint32_t joint, std::uint32_t axis, double velocity, double effort);
  /// Implicit: its force is that of the place and speed at the end of the step, so it is stable however stiff.
  /// To be told again before each step.
  void set_servo(std::uint32_t joint, std::uint32_t axis, const Servo& servo);
  void release(std::uint32_t joint, std::uint32_t axis);

  /// During the next step.
  void push(std::uint32_t body, const Vector3& impulse_W, const Vector3& p_BP);
  void set_gravity(const Vector3& gravity_W);
  void set_velocity(std::uint32_t body, const Vector3& v_WBcm, const Vector3& w_WB);

  /// Finds contacts where everything is now, without moving it: they are in `state()` then.
  void touch();
  void step(Forces forces = Forces::kNone);

  const State& state() const;

  /// How often ODE has said that its solver is in trouble, in this engine's time.
  std::uint64_t solver_messages() const;

 private:
  struct World;
  std::unique_ptr<World> world_;
};

}  // namespace rigor::simulate
