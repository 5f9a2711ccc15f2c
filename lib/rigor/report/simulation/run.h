// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A run of a simulation as a part of a page: how it ended, plots, and what was measured.
//
//   for (const simulate::Run& run : model.simulation.runs) page += run_html(model.scene, run);

#pragma once

#include <string>

#include <rigor/simulate/metric/metric.h>
#include <rigor/simulate/scene/scene.h>
#include <rigor/simulate/simulate.h>

namespace rigor::report {

/// The test, and the engine where that is not ODE: "settle", "settle (mujoco)".
std::string run_name(const simulate::Run& run);

/// The word in its color.
std::string verdict_html(simulate::Verdict verdict);

/// Under a heading of the third level; metrics are folded.
std::string run_html(const simulate::Scene& scene, const simulate::Run& run);

}  // namespace rigor::report
