// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What came of simulating models: a verdict, the runs with their metrics, the findings.
//
//   {"model": "my_robot/model.sdf", "verdict": "fail", "runs": [{"test": "drive", "verdict": "fail",
//    "metrics": [{"id": "tilt.max", "value": 3.1, "unit": "rad", "warn": 0.087, "fail": 0.52,
//    "verdict": "fail"}, …], …}], "diagnostics": […]}
//
// Of one model the JSON is an object, whose runs name their case where there are several; of several
// models a list of them under "models".

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <rigor/author/simulation.h>
#include <rigor/report/terminal/color.h>
#include <rigor/text/sources.h>

namespace rigor::report {

/// The models of a run; each was read through `sources`.
struct SimulationReport {
  const std::vector<author::SimulatedModel>& models;
  const Sources& sources;
  /// Images of the models for a page, as PNG, in the same order; empty without one, or shorter.
  std::vector<std::string> pictures = {};
};

/// Of such an image, in pixels.
inline constexpr std::uint32_t kSimulatedPictureWidth = 480;
inline constexpr std::uint32_t kSimulatedPictureHeight = 360;

/// A finding each as `validate` prints it, then a table of runs and what they measured; of several
/// models a table with a line for each.
std::string simulation_text(const SimulationReport& report, Color color);
std::string simulation_json(const SimulationReport& report);
/// One case as a line of JSON lines, with its end; see docs/scale.md.
std::string simulation_line(const author::SimulatedModel& model, const Sources& sources);
/// A test suite a model, a test case a run.
std::string simulation_junit(const SimulationReport& report);
/// The trajectories: a row each 10 ms, of each run.
std::string simulation_csv(const SimulationReport& report);
/// One page that loads nothing. Of each model first its image, its path, the verdict and the findings that say most
/// of why; all else is folded.
std::string simulation_html(const SimulationReport& report);

/// Its path, and of a point of a grid which one: "cart.sdf [friction=0.2 seed=1]".
std::string case_name(const author::SimulatedModel& model);

/// "2 models: 1 pass, 1 fail", "1 model in 6 cases: 6 pass", without a line break.
std::string simulation_summary(const SimulationReport& report);

}  // namespace rigor::report
