// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is compiled in place of the engine without ODE (RIGOR_WITH_ODE=OFF).

#include <rigor/simulate/engine/engine.h>
#include <rigor/simulate/engine/ode_version.h>

namespace rigor::simulate {
namespace {

[[noreturn]] void engine_is_absent() { throw EngineError("rigor was built without ODE"); }

}  // namespace

struct Engine::World {};

Engine::Engine(const Scene&, const SolverSettings&) { engine_is_absent(); }
Engine::~Engine() = default;

// There is no engine to call them on.
void Engine::set_effort(std::uint32_t, std::uint32_t, double) {}
void Engine::set_motor(std::uint32_t, std::uint32_t, double, double) {}
void Engine::set_servo(std::uint32_t, std::uint32_t, const Servo&) {}
void Engine::release(std::uint32_t, std::uint32_t) {}
void Engine::push(std::uint32_t, const Vector3&, const Vector3&) {}
void Engine::set_gravity(const Vector3&) {}
void Engine::set_velocity(std::uint32_t, const Vector3&, const Vector3&) {}
void Engine::touch() {}
void Engine::step(Forces) {}
const State& Engine::state() const { engine_is_absent(); }
std::uint64_t Engine::solver_messages() const { return 0; }

std::string ode_version() { return {}; }

}  // namespace rigor::simulate
