// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A scene in a physics engine, one step at a time: ODE (engine/ode) or MuJoCo (engine/mujoco), chosen by the
// settings. Only for a process of its own: both have globals, and report what they do not like by handlers that
// are set for the whole process; here they throw EngineError.
//
//   const std::unique_ptr<Engine> engine = make_engine(scene, settings);
//   engine->set_effort(joint, axis, 2.0);
//   engine->step();
//   watch.see(engine->state());
//
// What an engine does with a scene, and what it does not, is docs/engines.md's table.

#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>

#include <rigor/simulate/engine/state.h>
#include <rigor/simulate/scenario.h>
#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

/// What an engine said before it would have ended the process, or why it does not take a scene. The engine is of
/// no use after it, save that `state()` tells where bodies were left; nor is its library in this process when it
/// came from a step.
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
  Engine() = default;
  virtual ~Engine() = default;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// For the coming steps, until commanded otherwise; `effort` is cut at the axis' limit. A motor reaches
  /// the velocity with at most `effort`, and takes the place of the axis' friction meanwhile.
  virtual void set_effort(std::uint32_t joint, std::uint32_t axis, double effort) = 0;
  virtual void set_motor(std::uint32_t joint, std::uint32_t axis, double velocity,
                         double effort) = 0;
  /// Implicit: its force is that of the place and speed at the end of the step, so it is stable however stiff.
  /// To be told again before each step.
  virtual void set_servo(std::uint32_t joint, std::uint32_t axis, const Servo& servo) = 0;
  virtual void release(std::uint32_t joint, std::uint32_t axis) = 0;

  /// During the next step.
  virtual void push(std::uint32_t body, const Vector3& impulse_W, const Vector3& p_BP) = 0;
  virtual void set_gravity(const Vector3& gravity_W) = 0;
  /// Of a body that no joint carries.
  virtual void set_velocity(std::uint32_t body, const Vector3& v_WBcm, const Vector3& w_WB) = 0;

  /// Finds contacts where everything is now, without moving it: they are in `state()` then.
  virtual void touch() = 0;
  virtual void step(Forces forces) = 0;
  void step() { step(Forces::kNone); }

  virtual const State& state() const = 0;

  /// How often the engine has said that its solver is in trouble, in this engine's time.
  virtual std::uint64_t solver_messages() const = 0;
};

/// The scene must outlive it. An EngineError where the engine is not there, or does not take the scene.
std::unique_ptr<Engine> make_engine(const Scene& scene, const SolverSettings& settings);

}  // namespace rigor::simulate
