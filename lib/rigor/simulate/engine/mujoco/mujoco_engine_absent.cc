// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is compiled in place of the engine without MuJoCo's headers (RIGOR_WITH_MUJOCO=OFF).

#include <rigor/simulate/engine/mujoco/mujoco_engine.h>
#include <rigor/simulate/engine/mujoco/mujoco_version.h>

namespace rigor::simulate {

struct MujocoEngine::World {};

MujocoEngine::MujocoEngine(const Scene&, const SolverSettings&) {
  throw EngineError(mujoco_problem({}));
}
MujocoEngine::~MujocoEngine() = default;

// There is no engine to call them on.
void MujocoEngine::set_effort(std::uint32_t, std::uint32_t, double) {}
void MujocoEngine::set_motor(std::uint32_t, std::uint32_t, double, double) {}
void MujocoEngine::set_servo(std::uint32_t, std::uint32_t, const Servo&) {}
void MujocoEngine::release(std::uint32_t, std::uint32_t) {}
void MujocoEngine::push(std::uint32_t, const Vector3&, const Vector3&) {}
void MujocoEngine::set_gravity(const Vector3&) {}
void MujocoEngine::set_velocity(std::uint32_t, const Vector3&, const Vector3&) {}
void MujocoEngine::touch() {}
void MujocoEngine::step(Forces) {}
const State& MujocoEngine::state() const { throw EngineError(mujoco_problem({})); }
std::uint64_t MujocoEngine::solver_messages() const { return 0; }

std::string mujoco_problem(const std::string&) { return "rigor was built without MuJoCo"; }
std::string mujoco_version() { return {}; }

}  // namespace rigor::simulate
