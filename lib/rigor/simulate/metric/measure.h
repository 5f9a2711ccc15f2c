// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is watched at each step of a run: the largest speeds, gaps and forces in each phase, when it came
// to rest, how far it tilted. Metrics (metric.h) are made from these afterwards.
//
//   Watch watch(scene, scenario, settings);
//   for (watch.see(engine.state()); goes_on(); watch.see(engine.state())) engine.step();
//   record.measures = watch.measures();

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <rigor/simulate/engine/state.h>
#include <rigor/simulate/scenario.h>
#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

/// The largest value that was seen, and of what: an index of a body, axis or shape.
struct Peak {
  double value = 0;
  std::uint32_t of = kWorld;
  double at = 0;  ///< s

  void see(double seen, std::uint32_t whose, double when) {
    if (!(seen > value)) return;
    value = seen;
    of = whose;
    at = when;
  }
};

/// Of one phase of a scenario: of the states after its begin, up to its end. Phases may overlap.
struct PhaseMeasures {
  std::uint64_t steps = 0;
  Peak speed;         ///< m/s, of bodies' centers, but of what begins in the air
  Peak residual;      ///< m/s: of the farthest point of a body that is to rest: |v| + |w| · radius
  Peak acceleration;  ///< m/s², of bodies' centers, save in steps that a new contact begins in
  Peak energy;        ///< J above that at the start and what motors put in
  Peak tilt;          ///< rad, of the base of a model that stands, against its start; `of` a model
  Peak anchor_error;  ///< m; `of` a joint
  Peak limit_violation;  ///< rad or m; `of` an axis
  Peak penetration;      ///< m, into the world; `of` a shape
  Peak sunk;             ///< as `penetration`, at the last step only
  Peak self_contact;     ///< m, depth between shapes of one model; `of` the first shape
  std::uint32_t self_contact_with = kWorld;
  double tipped = kInfinity;          ///< s: when a base was first tilted by more than kTipped
  std::uint64_t contact_changes = 0;  ///< of the number of contacts with the world
  Vector3 ground_force;               ///< N·steps, sum over contacts with the world
  // Of each model's base; zero of one that is the world's.
  std::vector<double> vertical_square;  ///< m²/s²·steps
  std::vector<double> yaw_path;         ///< rad: integral of the turn rate about W's z
  // Of each axis.
  std::vector<double> jitter_square;  ///< (rad/s)²·steps above kJitterFrequency
  std::vector<double> axis_min;       ///< positions that it reached
  std::vector<double> axis_max;
  std::vector<double> axis_begin;  ///< positions as the phase began and ended
  std::vector<double> axis_end;
  std::vector<double> axis_path;  ///< rad or m, signed: integral of its velocity
  /// The largest share of its effort limit that a command took; what is shorter than kBlow is a blow.
  std::vector<double> axis_effort;
  // Of each body.
  std::vector<BodyState> begin;  ///< as the phase began and ended
  std::vector<BodyState> end;
};

/// Where a model stood on the world.
struct SupportPoint {
  std::uint32_t model = 0;
  Vector3 point;
};

struct Measures {
  std::vector<PhaseMeasures> phases;  ///< as in the scenario
  /// At the start: the deepest contact with the world, and between bodies that no joint connects.
  Peak spawn_penetration;  ///< `of` a shape
  Peak spawn_overlap;      ///< `of` the first shape
  std::uint32_t spawn_overlap_with = kWorld;
  double settle_time = kInfinity;  ///< s: slow from then on (kSettleHold) for the first time
  /// Contacts with the world in the last kSupportWindow of the first phase.
  std::vector<SupportPoint> support;
};

/// It has settled when all is slower than this for so long.
inline constexpr double kSettledSpeed = 0.005;  // m/s
inline constexpr double kSettledTurn = 0.05;    // rad/s
inline constexpr double kSettleHold = 0.25;     // s

/// A base that leans this far does not only rock on its wheels.
inline constexpr double kTipped = 0.15;  // rad

/// What joints of robots do on purpose is slower; contacts and stiff controllers chatter faster.
inline constexpr double kJitterFrequency = 20;  // Hz

/// A motor that is given another speed gives a blow in one step, which no real one could give.
inline constexpr double kBlow = 0.02;  // s, of a low-pass of first order

/// Contacts of one step may miss a corner that flickers; those of so many do not.
inline constexpr double kSupportWindow = 0.02;  // s

class Watch {
 public:
  Watch(const Scene& scene, const Scenario& scenario, const SolverSettings& settings);

  /// The state before the first step, and after each. Contacts are those that the step began with.
  void see(const State& state);

  const Measures& measures() const { return measures_; }

 private:
  struct StepPeaks;  // what one step adds to each phase that it is in

  struct WatchedBody {
    mass::MassProperties mass;
    double weight = 0;   // kg that gravity acts on
    bool moves = true;   // by forces
    bool falls = false;  // begins in the air
    bool rests = true;   // is to come to rest: neither in the air, nor free to swing
    double radius = 0;   // m: how far its shapes reach from its center of mass
  };
  struct WatchedAxis {
    double lower, upper, effort, spring_stiffness, spring_reference;
    // The high-pass filter: two of first order, one after the other.
    double seen = 0, first = 0, second = 0;
    double given = 0;  // the effort, through a low-pass
  };
  struct WatchedShape {
    std::uint32_t body = kWorld;
    std::uint32_t model = kWorld;
  };
  struct WatchedBase {
    std::uint32_t body = kWorld;
    Vector3 up_B;  // W's z in the body at the start
    bool stands = false;
  };

  void start(const State& state);
  void change_phases(double time);
  void see_bodies(const State& state, StepPeaks& peaks);
  void see_energy(const State& state, StepPeaks& peaks);
  void see_axes(const State& state, StepPeaks& peaks);
  void see_contacts(const State& state, StepPeaks& peaks);
  void add_to(PhaseMeasures& phase, const State& state, const StepPeaks& peaks) const;
  double energy(const State& state) const;
  bool work_from_outside(double time) const;
  void see_settling(double time, bool slow);

  const Scenario& scenario_;
  double step_;
  double filter_;
  Vector3 gravity_;
  bool conserves_ = true;  // nothing moves as commanded
  std::vector<WatchedBody> bodies_;
  std::vector<WatchedAxis> axes_;
  std::vector<WatchedShape> shapes_;
  std::vector<WatchedBase> bases_;  // of each model
  Measures measures_;
  std::vector<std::uint32_t> active_;  // phases
  double next_change_ = 0;             // s: when `active_` does
  bool started_ = false;
  std::vector<BodyState> before_;
  std::vector<AxisState> axes_before_;
  std::size_t contacts_before_ = 0;         // all, and
  std::size_t ground_contacts_before_ = 0;  // those with the world
  double energy_base_ = 0;
  double energy_before_ = 0;
  double slow_since_ = kInfinity;
};

}  // namespace rigor::simulate
