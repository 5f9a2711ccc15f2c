// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Runs a scenario in an engine and records it.
//
// `run` works in the calling process: engines have globals, and abort on what they do not like. So only a
// worker process calls it (for `run_isolated`, or `run_request` for many at once), which ends by itself after
// its steps, and by the request's limits in the worst case. For the same scene, scenario and settings the
// record is the same to the last bit.
//
//   Record record = run_isolated(scene, scenario, scene.solver, environment.workers);
//   if (record.end != Record::End::kDone) explain(record);

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/process/request.h>
#include <rigor/process/serve.h>
#include <rigor/process/workers.h>
#include <rigor/simulate/engine/state.h>
#include <rigor/simulate/metric/measure.h>
#include <rigor/simulate/scenario.h>
#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

/// A row of the trajectory is kept this often, s.
inline constexpr double kSampleInterval = 0.01;

/// What a run may take before it is ended: steps first. Ten million steps of a robot take some minutes,
/// and a thousand of a demonstration with 3,003 bodies nearly one: time is only for what hangs.
inline constexpr std::uint64_t kMaxSteps = 10'000'000;
inline constexpr process::RequestLimits kRunLimits{.cpu_seconds = 300,
                                                   .memory_bytes = std::uint64_t{2} << 30U};

struct Record {
  enum class End : std::uint8_t {
    kDone,
    kNotFinite,  ///< a pose or speed stopped being a number
    kFarAway,    ///< something is farther than 1000 sizes of the scene away
    kRefused,    ///< the engine stopped with an error; `message` is its words
    kCrashed,    ///< the worker did, or there is none; `message` says how
    kOutOfTime,
  };
  End end = End::kDone;
  std::string message;
  double end_time = 0;  ///< s
  std::uint64_t steps = 0;
  std::uint64_t solver_messages = 0;  ///< that the solver was in trouble
  std::uint32_t culprit = kWorld;     ///< body, of kNotFinite and kFarAway

  /// The trajectory: for each time, poses X_WL of all links, then position and velocity of all axes.
  std::vector<double> times;
  std::vector<Pose> link_poses;     ///< times × links
  std::vector<double> axis_values;  ///< times × axes × 2
  Measures measures;                ///< taken at each step
  State final;
  std::string state_hash;  ///< of all states that were sampled: equal for equal runs
};

/// Joint by joint, where its axes begin in `State::axes`; one more entry says how many there are.
std::vector<std::uint32_t> first_axes(const Scene& scene);

/// In this process. The scene is taken as it is: see `stage`.
Record run(const Scene& scene, const Scenario& scenario, const SolverSettings& settings);

/// In a worker.
Record run_isolated(const Scene& scene, const Scenario& scenario, const SolverSettings& settings,
                    const process::Workers& workers);

/// The same as a request, for many at once; `record_of` reads its result.
process::Request run_request(const Scene& scene, const Scenario& scenario,
                             const SolverSettings& settings);
Record record_of(const process::RequestResult& result);

/// s of CPU time that it took; `most` where it was ended for it.
double cpu_seconds_of(const process::RequestResult& result, double most);

/// Why the engine of these settings cannot be used; empty when it can. Asked in a worker.
std::string engine_problem(const SolverSettings& settings, const process::Workers& workers);

/// What a worker has to serve for these.
process::Service run_service();
process::Service engine_service();

/// A record as the bytes that a worker hands over, and back. Nothing when they are damaged.
std::string encode(const Record& record);
std::optional<Record> decode(std::string_view bytes);

}  // namespace rigor::simulate
