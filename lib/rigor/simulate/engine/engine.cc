// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/engine/engine.h>

#include <rigor/simulate/engine/mujoco/mujoco_engine.h>
#include <rigor/simulate/engine/ode/ode_engine.h>

namespace rigor::simulate {

std::unique_ptr<Engine> make_engine(const Scene& scene, const SolverSettings& settings) {
  if (settings.engine == EngineKind::kMujoco) {
    return std::make_unique<MujocoEngine>(scene, settings);
  }
  return std::make_unique<OdeEngine>(scene, settings);
}

}  // namespace rigor::simulate
