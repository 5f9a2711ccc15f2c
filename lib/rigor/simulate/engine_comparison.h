// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// ODE and MuJoCo side by side: the runs of each test, where they disagree beyond the band, and which property of the
// scene explains that. Private to the room.
//
//   compare_engines(scene, simulation);
//
// The band: a metric fails in one and not in the other; or both runs end, and models end farther apart than
// kEnginesApart. Whether a metric warns is within it: limits that warn lie where engines begin to differ.

#pragma once

#include <rigor/simulate/simulate.h>

namespace rigor::simulate {

/// Of a model's size or its way, whichever is longer: five times what two solvers of one engine may differ by
/// (the metric solver.agreement).
inline constexpr double kEnginesApart = 0.1;

/// Writes the comparisons, and a fact of kind kEnginesDiffer for each test with a difference into its later run.
void compare_engines(const Scene& scene, Simulation& simulation);

/// Which property of the scene makes the engines differ in these metrics; never empty.
std::string explanation_of(const Scene& scene, const EngineComparison& comparison);

}  // namespace rigor::simulate
