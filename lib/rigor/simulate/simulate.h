// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Simulates scenes in tests and says whether they are physically sane.
//
//   std::vector<Simulation> results = simulate({{scene, causes, {settle, drive}, wheels, scene.solver}},
//                                              {}, environment.workers);
//   if (results.front().verdict == Verdict::kFail) say(results.front().runs.front().facts);
//
// A failure is confirmed before it is believed: the same test with the other solver, and where that does not
// show it with half the step. What two of the three do not show is called the solver's. Each run is a worker process's; this function uses no threads and has at most
// `jobs` under way at a time, whichever task they are of. Those that a failure is confirmed by go before those of
// later tasks, so that a task that was begun is soon done.

#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <rigor/simulate/fact.h>
#include <rigor/simulate/metric/metric.h>
#include <rigor/simulate/run.h>
#include <rigor/simulate/scenario.h>
#include <rigor/simulate/scene/scene.h>
#include <rigor/simulate/wheels.h>

namespace rigor::simulate {

enum class Confirm : std::uint8_t { kNo, kFailures };

/// A scene in its scenarios. What is referred to outlives the call.
struct Task {
  const Scene& scene;
  const Facts& causes;  ///< advice/advice.h: facts of runs come with those that explain them
  std::vector<Scenario> scenarios;
  const DriveTrain& wheels;
  SolverSettings solver;  ///< usually the scene's; its seed is the run's
  /// Each scenario is run in each of them; where there are two their runs are held against each other.
  std::vector<EngineKind> engines{EngineKind::kOde};
};

struct SimulateOptions {
  Confirm confirm = Confirm::kFailures;
  unsigned jobs = 1;
  /// s of CPU time of workers, a task: what it does not suffice for is left out, and said. What is left out
  /// depends on the machine.
  double budget = kInfinity;
  /// Called here after each run, for progress: done, of how many that are known of.
  std::function<void(std::size_t, std::size_t)> progress = {};
};

/// One of the runs that a failure was held against.
struct Confirmation {
  std::string what;  ///< "half the step", "dantzig", "seed 1"
  Verdict verdict = Verdict::kPass;
  bool agrees = false;  ///< shows a failure of the run, or a warning that is in doubt
  bool in_time = true;  ///< else it says nothing about the run
  std::vector<std::string_view>
      lacking;  ///< metrics of which that is true in the run and not in this
};

struct Run {
  std::string test;
  std::uint64_t seed = 0;
  EngineKind engine = EngineKind::kOde;
  Verdict verdict = Verdict::kPass;
  Scenario scenario;
  std::vector<Metric> metrics;
  Facts facts;  ///< what it showed, each followed by its causes
  std::vector<Confirmation> confirmations;
  Record record;
};

/// A metric in two engines.
struct MetricPair {
  std::string_view id;
  std::string_view unit;
  double ode = 0;
  double mujoco = 0;
  Verdict ode_verdict = Verdict::kPass;
  Verdict mujoco_verdict = Verdict::kPass;
};

/// A test in ODE and in MuJoCo (engine_comparison.h).
struct EngineComparison {
  std::string test;
  Verdict ode = Verdict::kPass;
  Verdict mujoco = Verdict::kPass;
  double apart = 0;  ///< of where models end, a share of their size or way; infinite without an end
  std::vector<MetricPair> metrics;       ///< those of both
  std::vector<std::string> differences;  ///< beyond the band, in words
  std::string explanation;               ///< which property of the scene explains them
};

struct Simulation {
  Verdict verdict = Verdict::kPass;  ///< the worst of the runs': invalid, fail, solver, warn, pass
  std::vector<Run> runs;
  std::vector<EngineComparison> comparisons;  ///< where there are two engines
  std::vector<std::string> left_out;          ///< what the budget did not suffice for
};

/// In the order of the tasks; the same for any number of jobs.
std::vector<Simulation> simulate(const std::vector<Task>& tasks, const SimulateOptions& options,
                                 const process::Workers& workers);

/// Hands each over, with the number of its task, as soon as it is done: nothing is kept of it. Which is done
/// first depends on how long they take.
void simulate(const std::vector<Task>& tasks, const SimulateOptions& options,
              const process::Workers& workers,
              const std::function<void(std::size_t, Simulation)>& done);

/// The worse of two.
Verdict worse(Verdict a, Verdict b);

}  // namespace rigor::simulate
