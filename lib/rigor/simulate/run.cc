// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/run.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <ctime>
#include <memory>
#include <stdexcept>
#include <utility>

#include <rigor/simulate/commander.h>
#include <rigor/simulate/engine/engine.h>
#include <rigor/simulate/engine/mujoco/mujoco_engine.h>
#include <rigor/simulate/engine/ode/ode_version.h>
#include <rigor/simulate/run_request.h>
#include <rigor/text/digest.h>

namespace rigor::simulate {
namespace {

constexpr std::string_view kRunKind = "simulate.run";
constexpr std::string_view kEngineKind = "simulate.engine";

/// m: a scene smaller than this is given this size when it is asked whether something is far away.
constexpr double kNearbySize = 0.1;
constexpr double kFarSizes = 1000;

/// Steps that a duration takes; a duration is a product that was rounded.
constexpr double kWholeStep = 1e-6;

/// Numbers that a trajectory may hold (half a gigabyte): a long run of many links has fewer rows.
constexpr std::size_t kMaxNumbers = std::size_t{1} << 26U;

std::uint64_t run_steps(double duration, double step) {
  return static_cast<std::uint64_t>(std::max(0.0, std::ceil(duration / step - kWholeStep)));
}

bool is_run_finite(const Vector3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool is_run_finite(const BodyState& body) {
  const Quaternion& q = body.R_WB;
  return is_run_finite(body.p_WBcm) && is_run_finite(body.v_WBcm) && is_run_finite(body.w_WB) &&
         std::isfinite(q.w) && std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z);
}

template <class T>
std::string_view state_bytes(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

class Recorder {
 public:
  Recorder(const Scene& scene, const Scenario& scenario, const SolverSettings& settings,
           std::uint64_t steps)
      : scene_(scene), watch_(scene, scenario, settings) {
    const double interval = std::round(kSampleInterval / settings.step);
    every_ = interval > 1 ? static_cast<std::uint64_t>(interval) : 1;
    const std::uint64_t numbers = 1 + 7 * scene.links.size() + 2 * first_axes(scene).back();
    const std::uint64_t rows = std::max<std::uint64_t>(2, kMaxNumbers / numbers);
    every_ = std::max(every_, steps / rows + 1);
    farthest_ = kFarSizes * std::max(scene.size, kNearbySize);
  }

  /// False when the next step must not be made.
  bool see(const State& state, std::uint64_t steps) {
    watch_.see(state);
    record_.steps = steps;
    record_.end_time = state.time;
    if (!sane(state)) return false;
    if (steps % every_ == 0) sample(state);
    return true;
  }

  Record finish(const State& state, std::uint64_t messages) {
    if (record_.times.empty() || record_.times.back() != state.time) sample(state);
    record_.final = state;
    record_.solver_messages = messages;
    return close();
  }

  /// `state`: of the engine that stopped; null when there is none yet. ODE stops at some numbers that
  /// are none before they are seen here.
  Record refuse(const std::string& words, const State* state) {
    record_.end = Record::End::kRefused;
    record_.message = words;
    if (state != nullptr) static_cast<void>(sane(*state));
    return close();
  }

 private:
  Record close() {
    record_.measures = watch_.measures();
    record_.state_hash = hex(hasher_.digest());
    return std::move(record_);
  }

  bool sane(const State& state) {
    if (starts_.empty()) {
      for (const BodyState& body : state.bodies) starts_.push_back(body.p_WBcm);
    }
    for (std::uint32_t i = 0; i < state.bodies.size(); ++i) {
      const BodyState& body = state.bodies[i];
      if (!is_run_finite(body)) return end_for(Record::End::kNotFinite, i);
      const Vector3 way = body.p_WBcm - starts_[i];
      if (dot(way, way) > farthest_ * farthest_) return end_for(Record::End::kFarAway, i);
    }
    return true;
  }

  bool end_for(Record::End why, std::uint32_t body) {
    record_.end = why;
    record_.culprit = body;
    return false;
  }

  void sample(const State& state) {
    record_.times.push_back(state.time);
    for (const SceneLink& link : scene_.links) {
      record_.link_poses.push_back(
          link.body == kWorld
              ? link.X_BL
              : compose(pose_of(scene_.bodies[link.body], state.bodies[link.body]), link.X_BL));
    }
    for (const AxisState& axis : state.axes) {
      record_.axis_values.push_back(axis.position);
      record_.axis_values.push_back(axis.velocity);
    }
    hasher_.add(state_bytes(state.bodies));
    hasher_.add(state_bytes(state.axes));
  }

  const Scene& scene_;
  Watch watch_;
  Record record_;
  Hasher hasher_;
  std::uint64_t every_ = 1;
  double farthest_ = 0;
  std::vector<Vector3> starts_;
};

/// s: what a worker that crashed is taken to have used. Most do so at once.
constexpr double kCrashTime = 1;

/// After the record, as it lies in memory: both ends are of one build.
std::string encode_seconds(double seconds) {
  return {reinterpret_cast<const char*>(&seconds), sizeof seconds};
}

/// In the worker.
process::Reply run_requested(const std::string& bytes, const process::Ask& /*ask*/) {
  const std::optional<RunRequest> request = decode_run(bytes);
  if (!request) throw std::invalid_argument("the scene is damaged");
  const std::clock_t begin = std::clock();
  const Record record = run(request->scene, request->scenario, request->settings);
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  // An engine does not come back from an error within a step.
  const bool refused = record.end == Record::End::kRefused;
  return {encode(record) + encode_seconds(seconds),
          refused ? process::Reply::Then::kRetire : process::Reply::Then::kServeAgain};
}

/// In the worker, too: a library that is opened may do anything.
process::Reply mujoco_requested(const std::string& library, const process::Ask& /*ask*/) {
  return {mujoco_problem(library), process::Reply::Then::kRetire};
}

}  // namespace

std::vector<std::uint32_t> first_axes(const Scene& scene) {
  std::vector<std::uint32_t> first{0};
  for (const SceneJoint& joint : scene.joints) {
    first.push_back(first.back() + static_cast<std::uint32_t>(joint.axes.size()));
  }
  return first;
}

Record run(const Scene& scene, const Scenario& scenario, const SolverSettings& settings) {
  if (!(scenario.duration / settings.step <= static_cast<double>(kMaxSteps))) {
    Record record;
    record.end = Record::End::kOutOfTime;
    record.message = "it would take more than " + std::to_string(kMaxSteps) + " steps";
    return record;
  }
  const std::uint64_t steps = run_steps(scenario.duration, settings.step);
  Recorder recorder(scene, scenario, settings, steps);
  std::unique_ptr<Engine> made;
  try {
    made = make_engine(scene, settings);
    Engine& engine = *made;
    Commander commander(scene, scenario, settings);
    engine.touch();
    bool goes_on = recorder.see(engine.state(), 0);
    for (std::uint64_t i = 1; i <= steps && goes_on; ++i) {
      commander.tell(engine);
      engine.step(Forces::kAsked);
      goes_on = recorder.see(engine.state(), i);
    }
    return recorder.finish(engine.state(), engine.solver_messages());
  } catch (const EngineError& error) {
    return recorder.refuse(error.what(), made ? &made->state() : nullptr);
  }
}

Record run_isolated(const Scene& scene, const Scenario& scenario, const SolverSettings& settings,
                    const process::Workers& workers) {
  return record_of(workers.call(run_request(scene, scenario, settings)));
}

process::Request run_request(const Scene& scene, const Scenario& scenario,
                             const SolverSettings& settings) {
  return {.kind = kRunKind, .bytes = encode_run(scene, scenario, settings), .limits = kRunLimits};
}

process::Service run_service() { return {kRunKind, run_requested}; }
process::Service engine_service() { return {kEngineKind, mujoco_requested}; }

std::string engine_problem(const SolverSettings& settings, const process::Workers& workers) {
  if (settings.engine == EngineKind::kOde) {
    return ode_version().empty() ? "rigor was built without ODE" : std::string();
  }
  const process::RequestResult result =
      workers.call({.kind = kEngineKind, .bytes = settings.library, .limits = kRunLimits});
  if (result.end == process::RequestResult::End::kDone) return result.bytes;
  return "MuJoCo's library cannot be opened: " + describe(result, kRunLimits);
}

Record record_of(const process::RequestResult& result) {
  using End = process::RequestResult::End;
  Record record;
  record.end = result.end == End::kOutOfTime ? Record::End::kOutOfTime : Record::End::kCrashed;
  record.message = describe(result, kRunLimits);
  if (result.end != End::kDone) return record;
  const std::size_t size = result.bytes.size();
  std::optional<Record> whole;
  if (size > sizeof(double)) {
    whole = decode(std::string_view(result.bytes).substr(0, size - sizeof(double)));
  }
  if (whole) return *std::move(whole);
  record.message = "handed over a damaged record";
  return record;
}

double cpu_seconds_of(const process::RequestResult& result, double most) {
  using End = process::RequestResult::End;
  if (result.end == End::kOutOfTime) return most;
  double seconds = std::min(most, kCrashTime);
  if (result.end != End::kDone || result.bytes.size() < sizeof seconds) return seconds;
  std::memcpy(&seconds, result.bytes.data() + result.bytes.size() - sizeof seconds, sizeof seconds);
  return std::min(seconds, most);
}

}  // namespace rigor::simulate
