// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A scene in ODE. How SDF's words become ODE's follows Gazebo 11 where its sources were read (docs/simulate.md
// has the table).
//
//   OdeEngine engine(scene, settings);
//   engine.step();
//
// ODE: R. Smith, "Open Dynamics Engine User Guide", 2006, and its 0.16 sources.

#pragma once

#include <cstdint>
#include <memory>

#include <rigor/simulate/engine/engine.h>

namespace rigor::simulate {

class OdeEngine final : public Engine {
 public:
  /// The scene must outlive it. An EngineError in a build without ODE.
  OdeEngine(const Scene& scene, const SolverSettings& settings);
  ~OdeEngine() override;

  using Engine::step;
  void set_effort(std::uint32_t joint, std::uint32_t axis, double effort) override;
  void set_motor(std::uint32_t joint, std::uint32_t axis, double velocity, double effort) override;
  void set_servo(std::uint32_t joint, std::uint32_t axis, const Servo& servo) override;
  void release(std::uint32_t joint, std::uint32_t axis) override;
  void push(std::uint32_t body, const Vector3& impulse_W, const Vector3& p_BP) override;
  void set_gravity(const Vector3& gravity_W) override;
  /// Of any body.
  void set_velocity(std::uint32_t body, const Vector3& v_WBcm, const Vector3& w_WB) override;
  void touch() override;
  void step(Forces forces) override;
  const State& state() const override;
  std::uint64_t solver_messages() const override;

 private:
  struct World;
  std::unique_ptr<World> world_;
};

}  // namespace rigor::simulate
