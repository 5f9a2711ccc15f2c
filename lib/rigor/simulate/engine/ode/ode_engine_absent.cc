// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is compiled in place of the engine without ODE (RIGOR_WITH_ODE=OFF).

#include <rigor/simulate/engine/ode/ode_engine.h>
#include <rigor/simulate/engine/ode/ode_version.h>

namespace rigor::simulate {
namespace {

[[noreturn]] void engine_is_absent() { throw EngineError("rigor was built without ODE"); }

}  // namespace

struct OdeEngine::World {};

OdeEngine::OdeEngine(const Scene&, const SolverSettings&) { engine_is_absent(); }
OdeEngine::~OdeEngine() = default;

// There is no engine to call them on.
void OdeEngine::set_effort(std::uint32_t, std::uint32_t, double) {}
void OdeEngine::set_motor(std::uint32_t, std::uint32_t, double, double) {}
void OdeEngine::set_servo(std::uint32_t, std::uint32_t, const Servo&) {}
void OdeEngine::release(std::uint32_t, std::uint32_t) {}
void OdeEngine::push(std::uint32_t, const Vector3&, const Vector3&) {}
void OdeEngine::set_gravity(const Vector3&) {}
void OdeEngine::set_velocity(std::uint32_t, const Vector3&, const Vector3&) {}
void OdeEngine::touch() {}
void OdeEngine::step(Forces) {}
const State& OdeEngine::state() const { engine_is_absent(); }
std::uint64_t OdeEngine::solver_messages() const { return 0; }

std::string ode_version() { return {}; }

}  // namespace rigor::simulate
