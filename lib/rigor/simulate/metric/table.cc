// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The limits of all metrics, and why they are what they are. What is said of "sane" robots was measured
// on Gazebo's tutorial robot with right inertias (docs/simulate.md).

#include <rigor/simulate/metric/parts.h>

#include <algorithm>
#include <cmath>

namespace rigor::simulate {
namespace {

constexpr double kDegree = 0.017453292519943295;

using enum FactKind;

constexpr std::optional<double> kNone;

/// Of a limit: what is at it but for how a file rounds, as pi/2 to 1.5708, is not beyond it.
constexpr double kRounding = 1e-4;

constexpr MetricRow kMetricRows[] = {
    // Poses that are no numbers, or farther away than 1000 sizes, are no matter of degree.
    {"state.nonfinite", "", kExplodes, kNone, 0.5},
    {"state.oversize", "", kExplodes, kNone, 0.5},
    // Of the speed of a fall through the robot's own size, and of what was commanded. A sane robot has
    // 0.003 at rest and less than 1 always; 5 cm of overlap that are solved at once shoot it off at 15.
    {"speed.peak", "", kTooFast, 1.5, 3},
    // In g, impacts aside: 0.4 for a sane robot. Contacts that chatter have hundreds.
    {"accel.peak", "g", kTooFast, 50, 500},
    // Of M g size. A sane robot has 1e-9; a soft stop or overlap has some per cent.
    {"energy.gain", "", kEnergyGained, 0.01, 0.1},
    // m. The solver lets contacts rest a millimeter deep; from 5 mm on they push visibly.
    {"spawn.penetration", "m", kSpawnedInGround, 0.001, 0.005},
    // m. Links that overlap push each other for ever when a joint keeps them there.
    {"spawn.self_overlap", "m", kSelfOverlap, 0.0001, 0.002},
    // m above the ground. Not what was drawn, but harmless: it falls.
    {"spawn.gap", "m", kSpawnedAbove, 0.005, kNone},
    // s until all is slow. After a drop of 10 cm a sane robot needs 0.14.
    {"settle.time", "s", kNeverSettles, 1, 2},
    // m/s, |v| + |w| r at rest: 5e-4 for a sane robot, 1.6e-3 on mesh wheels, 4e-3 on springs.
    {"rest.residual_v", "m/s", kRestless, 0.005, 0.02},
    // m/s and rad/s: 1e-5 for a sane robot. 5 mm/s is a length of most robots in two minutes.
    {"rest.creep", "m/s", kCreeps, 0.0005, 0.005},
    {"rest.yaw_creep", "rad/s", kCreeps, 0.001, 0.01},
    // Share of the weight by which the ground's force is off: 5e-5 for a sane robot.
    {"rest.weight_balance", "", kUnbalanced, 0.005, 0.01},
    // Changes a second: 0 for a sane robot, 30 on mesh wheels, 225 with default inertias. Alone it is
    // no failure: many bodies in many contacts have it too.
    {"rest.contacts", "1/s", kRestless, 100, kNone},
    // Of half the footprint's width. Below 0 it falls.
    {"rest.support_margin", "", kNearlyTips, 0.1, 0.0, BadSide::kBelow},
    {"rest.falls", "", kFalls, kNone, 0.5},
    // rad. 8.6° is the most that robots' own tests in the wild allow; nothing stands at 30°.
    {"tilt.max", "rad", kTips, 5 * kDegree, 30 * kDegree},
    // m. Contacts rest up to a millimeter deep by design (the surface layer).
    {"ground.sink", "m", kSinks, 0.0015, 0.005},
    // m, for a robot of a meter; in proportion for a larger one. A chain with a mass ratio of 100 has
    // 1.4 mm, a sane robot 5e-8.
    {"joint.anchor_error", "m", kAnchorError, 0.0001, 0.001},
    {"joint.limit_violation", "rad", kLimitViolated, 0.001, 0.01},
    // rad/s, RMS above 20 Hz: 1e-4 for a sane robot, 9e-3 on mesh wheels.
    {"joint.jitter", "rad/s", kJointJitters, 0.01, 0.1},
    // kd h/I: an explicit controller is unstable from 2 on (semi-implicit Euler).
    {"joint.pd_margin", "", kStiffControl, 0.5, 2},
    {"selfcollide.depth", "m", kSelfCollides, 0.0001, 0.002},
    // |way/(wheels' angle · radius) - 1|: 6e-6 for a sane robot, 3 % on mesh wheels of 32 corners.
    {"drive.ratio", "", kDriveSlips, 0.01, 0.05},
    {"drive.reached", "", kJointOverloaded, 0.95, 0.5, BadSide::kBelow},
    // Way ahead for each meter that the wheels roll. Below a half it goes somewhere else.
    {"drive.direction", "", kDriveBackwards, 0.9, 0.5, BadSide::kBelow},
    // Of the way: 4e-5 for a sane robot.
    {"drive.lateral", "", kDriveDrifts, 0.005, 0.05},
    {"drive.yaw", "rad", kDriveDrifts, 0.005, 0.05},
    // m/s, RMS: 1e-6 for a sane robot, 0.03 on mesh wheels.
    {"drive.bounce", "m/s", kDriveBounces, 0.005, 0.05},
    // How far the turn is outside of what the wheels' width leaves open. A solver may roll a wide
    // wheel on its inner or its outer edge (measured: -16 % to +24 %).
    {"turn.arc", "", kTurnOff, 0.02, 0.1},
    {"turn.spin", "", kTurnOff, 0.02, 0.1},
    // Of the speed before: it should stand a second after the wheels do.
    {"brake.speed", "", kDoesNotBrake, 0.02, 0.1},
    {"push.tilt", "rad", kPushedOver, 5 * kDegree, 30 * kDegree},
    // Of the joint's way, what is missing of it.
    {"joint.reach", "", kJointShort, 0.01, 0.1},
    // Of the effort limit. All of it is a joint without reserve; more is friction and damping that the
    // joint's motor can't overcome.
    {"joint.effort", "", kJointOverloaded, 0.999, 1.001},
    // rad. The test's gains let a load bend a joint by 0.005.
    {"hold.error", "rad", kDoesNotHold, 0.02, 0.1},
    // Of the angle that the footprint and the center of mass give.
    {"tilt-table.angle", "", kTiltsEarly, 0.9, 0.7, BadSide::kBelow},
    {"solver.messages", "", kSolverDiffers, kNone, kNone},
    // Relative changes of where the robot ends: 1e-4 for a sane one. Without a limit to fail at: a
    // pile that falls differently is no fault of the model's.
    {"dt.sensitivity", "", kStepSensitive, 0.02, kNone},
    {"seed.spread", "", kSeedSensitive, 0.01, kNone},
    {"solver.agreement", "", kSolverDiffers, 0.02, kNone},
};

}  // namespace

std::span<const MetricRow> metric_rows() { return kMetricRows; }

Metric make_metric(std::string_view id, double value, Fact about, double scale) {
  const std::span<const MetricRow> rows = metric_rows();
  const auto row =
      std::find_if(rows.begin(), rows.end(), [&](const MetricRow& r) { return r.id == id; });
  Metric metric{.id = row->id, .value = value, .unit = row->unit};
  if (about.slides && row->unit == "rad") metric.unit = "m";
  if (about.slides && row->unit == "rad/s") metric.unit = "m/s";
  if (row->warn) metric.warn = *row->warn * scale;
  if (row->fail) metric.fail = *row->fail * scale;
  const auto beyond = [&](const std::optional<double>& limit) {
    if (!limit) return false;
    const double slack = kRounding * std::abs(*limit);
    return !(row->bad == BadSide::kAbove ? value <= *limit + slack
                                         : value >= *limit - slack);  // NaN is beyond
  };
  metric.verdict = beyond(metric.fail)   ? Verdict::kFail
                   : beyond(metric.warn) ? Verdict::kWarn
                                         : Verdict::kPass;
  if (metric.verdict == Verdict::kPass) return metric;
  about.kind = row->kind;
  if (about.name.empty()) about.name = row->id;  // several metrics have one kind
  about.value = value;
  about.severe = metric.verdict == Verdict::kFail;
  about.limit = about.severe ? *metric.fail : *metric.warn;
  metric.fact = std::move(about);
  return metric;
}

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPass: return "pass";
    case Verdict::kWarn: return "warn";
    case Verdict::kFail: return "fail";
    case Verdict::kSolver: return "solver";
    case Verdict::kInvalid: return "invalid";
  }
  return "invalid";
}

}  // namespace rigor::simulate
