// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A scene in MuJoCo, whose library is opened when the first engine is made. Constraints are those of MuJoCo's own
// solver: a motor is a row of joint friction whose speed is the commanded one, so its effort is limited within the
// solver, and a servo is the same with a softness. docs/engines.md says what differs from ODE, and why.
//
//   MujocoEngine engine(scene, settings);
//   engine.step();
//
// MuJoCo: E. Todorov, T. Erez, Y. Tassa, "MuJoCo: A physics engine for model-based control", IROS 2012, and the
// documentation of 2.2.2, "Computation".

#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include <rigor/simulate/engine/engine.h>

namespace rigor::simulate {

class MujocoEngine final : public Engine {
 public:
  /// The scene must outlive it. An EngineError in a build without MuJoCo's headers, where its library is not found
  /// or of another version, and for a scene that MuJoCo does not take.
  MujocoEngine(const Scene& scene, const SolverSettings& settings);
  ~MujocoEngine() override;

  using Engine::step;
  void set_effort(std::uint32_t joint, std::uint32_t axis, double effort) override;
  void set_motor(std::uint32_t joint, std::uint32_t axis, double velocity, double effort) override;
  void set_servo(std::uint32_t joint, std::uint32_t axis, const Servo& servo) override;
  void release(std::uint32_t joint, std::uint32_t axis) override;
  void push(std::uint32_t body, const Vector3& impulse_W, const Vector3& p_BP) override;
  void set_gravity(const Vector3& gravity_W) override;
  void set_velocity(std::uint32_t body, const Vector3& v_WBcm, const Vector3& w_WB) override;
  void touch() override;
  void step(Forces forces) override;
  const State& state() const override;
  std::uint64_t solver_messages() const override;

 private:
  struct World;
  std::unique_ptr<World> world_;
};

/// Why MuJoCo's library cannot be used in this process; empty when it can. `path` as in SolverSettings::library.
std::string mujoco_problem(const std::string& path);

}  // namespace rigor::simulate
