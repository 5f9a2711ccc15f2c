// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests of joints: each driven from limit to limit, and all held by controllers against gravity.

#include <rigor/simulate/test/parts.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <rigor/simulate/joint_load.h>
#include <rigor/simulate/metric/parts.h>

namespace rigor::simulate {
namespace {

/// Of the joint's velocity limit; and what is taken at most.
constexpr double kSweepShare = 0.25;
constexpr double kSweepTurn = 1;           // rad/s
constexpr double kSweepSlideShare = 0.25;  // of the scene's size, a second

/// A stroke takes no longer than this, if the joint's limit lets it: a sweep is not to take minutes.
constexpr double kStrokeMost = 3;  // s

/// From rest to full speed and back; a step of speed would be a blow to all that hangs on the joint.
constexpr double kStrokeRamp = 0.25;  // s

/// At a limit it waits for so long, and takes half of it to get there exactly.
constexpr double kStrokeRest = 0.2;  // s

/// Whatever a file's limits are, all strokes together end: an hour of simulated time takes minutes.
constexpr double kSweepMost = 600;  // s

constexpr double kHoldTime = 2;  // s

/// A controller with this natural frequency is brisk; and with this much damping it does not swing.
constexpr double kHoldFrequency = 20;  // rad/s
constexpr double kHoldDamping = 0.7;

/// How far the load may bend it: gains are raised until it is less.
constexpr double kHoldSag = 0.005;  // rad, m

struct SweepRange {
  double lower, upper, speed;
};

SweepRange sweep_range(const Scene& scene, const SceneJoint& joint) {
  const SceneAxis& axis = joint.axes[0];
  const bool slides = joint.type == model::JointType::kPrismatic;
  const double open = slides ? scene.size / 4 : std::numbers::pi;
  SweepRange range{std::isfinite(axis.lower) ? axis.lower : -open,
                   std::isfinite(axis.upper) ? axis.upper : open, 0};
  // Beyond a full turn and back there is nothing new.
  if (!slides) {
    range.lower = std::max(range.lower, -2 * std::numbers::pi);
    range.upper = std::min(range.upper, 2 * std::numbers::pi);
  }
  const bool limited = std::isfinite(axis.velocity) && axis.velocity > 0;
  const double usual = slides ? kSweepSlideShare * scene.size : kSweepTurn;
  // Many files write 1000 rad/s for "no limit".
  range.speed = limited ? std::min(kSweepShare * axis.velocity, usual) : usual;
  const double needed = (range.upper - range.lower) / kStrokeMost;
  range.speed = std::max(range.speed, limited ? std::min(needed, axis.velocity) : needed);
  return range;
}

/// The joints that motors move.
struct DrivenJoints {
  std::vector<std::uint32_t> joints;
  bool some_lack_effort = false;  ///< whether there are more, but that their effort limit is 0

  std::string why_none() const {
    return some_lack_effort ? "no motor can move a joint: their effort limits are 0"
                            : "no joint can be moved by itself";
  }
};

DrivenJoints driven_joints(const Scene& scene, const DriveTrain& wheels) {
  const std::vector<bool> rolling = rolling_joints(scene);
  DrivenJoints driven;
  for (std::uint32_t j = 0; j < scene.joints.size(); ++j) {
    const SceneJoint& joint = scene.joints[j];
    if (!can_be_commanded(joint) || joint.child >= scene.bodies.size()) continue;
    if (is_wheel_joint(wheels, j) || rolling[j] || joint.axes[0].spring_stiffness != 0) continue;
    if (!(joint.axes[0].lower < joint.axes[0].upper)) continue;
    if (joint.axes[0].effort > 0) {
      driven.joints.push_back(j);
    } else {
      driven.some_lack_effort = true;
    }
  }
  return driven;
}

std::string effort_note(const DrivenJoints& driven) {
  return driven.some_lack_effort ? "joints whose effort limit is 0 move freely" : "";
}

/// Speeds up and slows down evenly, and ends exactly at `to`.
double add_stroke(std::uint32_t joint, double from, double to, double speed, double begin,
                  Scenario& scenario) {
  const double cruise = std::abs(to - from) / speed;
  const double ramp = std::min(kStrokeRamp, cruise / 2);
  const auto add = [&](CommandKind kind, double value, double start, double end, double rise) {
    scenario.commands.push_back(
        {.joint = joint, .kind = kind, .value = value, .begin = start, .end = end, .ramp = rise});
  };
  const double arrived = begin + cruise + ramp;
  add(CommandKind::kVelocity, to < from ? -speed : speed, begin, begin + cruise, ramp);
  add(CommandKind::kVelocity, 0, begin + cruise, arrived, ramp);
  add(CommandKind::kPosition, to, arrived, arrived + kStrokeRest, kStrokeRest / 2);
  return arrived + kStrokeRest;
}

/// Stands still but while it is swept.
void add_stand(std::uint32_t joint, double begin, double end, Scenario& scenario) {
  if (!(end > begin)) return;
  scenario.commands.push_back(
      {.joint = joint, .kind = CommandKind::kVelocity, .value = 0, .begin = begin, .end = end});
}

/// No gain that asks for all of the effort before the load's own sag: with less there is nothing to add, and a
/// real controller would only swing between the two.
Gains hold_gains(const JointLoads& loads, const SceneJoint& joint) {
  const double inertia = loads.standing_inertia(joint);
  const double effort = joint.axes[0].effort;
  Gains gains;
  gains.p = std::max(inertia * kHoldFrequency * kHoldFrequency, loads.standing(joint) / kHoldSag);
  if (effort > 0) gains.p = std::min(gains.p, effort / kHoldSag);
  gains.d = 2 * kHoldDamping * std::sqrt(gains.p * inertia);
  return gains;
}

/// Where it begins, a load's sag off its stops: a spring and a stop at one place throw the joint to and fro.
double held_position(const SceneAxis& axis) {
  const double margin = std::min(kHoldSag, (axis.upper - axis.lower) / 2);
  return std::clamp(axis.start, axis.lower + margin, axis.upper - margin);
}

/// When each joint is swept. One after the other; but joints on different branches of a base that is held do not
/// feel each other and go at the same time, unless links may touch or a joint moves others along.
class SweepSchedule {
 public:
  explicit SweepSchedule(const Scene& scene)
      : carried_(scene), busy_(scene.bodies.size(), 0), serial_(is_serial(scene)) {}

  /// From `earliest` on.
  double begin_of(const SceneJoint& joint, double earliest) const {
    double begin = std::max(earliest, serial_ ? latest_ : 0);
    if (serial_) return begin;
    for (const std::uint32_t body : carried_.by(joint.child)) begin = std::max(begin, busy_[body]);
    return begin;
  }

  void take(const SceneJoint& joint, double end) {
    latest_ = std::max(latest_, end);
    if (serial_) return;
    for (const std::uint32_t body : carried_.by(joint.child)) busy_[body] = end;
  }

  double end() const { return latest_; }

 private:
  static bool is_serial(const Scene& scene) {
    std::vector<bool> hangs(scene.bodies.size());
    for (const SceneJoint& joint : scene.joints) {
      if (!joint.mimics.empty() || joint.type == model::JointType::kGearbox) return true;
      if (joint.child >= hangs.size()) continue;
      if (hangs[joint.child]) return true;  // a loop
      hangs[joint.child] = true;
    }
    for (const SceneBody& body : scene.bodies) {
      if (body.self_collide) return true;
    }
    for (std::uint32_t m = 0; m < scene.models.size(); ++m) {
      if (stands_free(scene, m)) return true;
    }
    return false;
  }

  CarriedBodies carried_;
  std::vector<double> busy_;  // s, of each body: until when a joint that carries it is swept
  double latest_ = 0;
  bool serial_;
};

}  // namespace

MadeTest make_joint_sweep(const Scene& scene, const DriveTrain& wheels) {
  const DrivenJoints driven = driven_joints(scene, wheels);
  const std::vector<std::uint32_t>& joints = driven.joints;
  if (joints.empty()) return {{}, driven.why_none()};
  Scenario scenario{.name = "joint-sweep", .spawn = Spawn::kOnGround};
  const double settled = settling_time(scene) / 2;
  scenario.phases.push_back({"settle", 0, settled});
  std::vector<Phase> swept;
  SweepSchedule schedule(scene);
  for (const std::uint32_t j : joints) {
    const SweepRange range = sweep_range(scene, scene.joints[j]);
    const double start = std::clamp(scene.joints[j].axes[0].start, range.lower, range.upper);
    const double begin = schedule.begin_of(scene.joints[j], settled);
    double time = begin;
    time = add_stroke(j, start, range.lower, range.speed, time, scenario);
    time = add_stroke(j, range.lower, range.upper, range.speed, time, scenario);
    time = add_stroke(j, range.upper, start, range.speed, time, scenario);
    swept.push_back({"sweep " + scene.joints[j].name, begin, time});
    schedule.take(scene.joints[j], time);
    if (schedule.end() > kSweepMost) break;
  }
  const double time = schedule.end();
  scenario.duration = time;
  scenario.phases.insert(scenario.phases.end(), swept.begin(), swept.end());
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const bool is_swept = i < swept.size();
    add_stand(joints[i], 0, is_swept ? swept[i].begin : time, scenario);
    if (is_swept) add_stand(joints[i], swept[i].end, time, scenario);
  }
  add_drive(wheels, 0, 0, {"", 0, time}, 0, scenario);
  return {std::move(scenario), {}, effort_note(driven)};
}

MadeTest make_hold(const Scene& scene, const DriveTrain& wheels) {
  Scenario scenario{.name = "hold", .duration = kHoldTime, .spawn = Spawn::kOnGround};
  scenario.phases = {{"hold", 0, kHoldTime}, rest_of(0, kHoldTime)};
  const JointLoads loads(scene);
  const DrivenJoints driven = driven_joints(scene, wheels);
  for (const std::uint32_t j : driven.joints) {
    const SceneAxis& axis = scene.joints[j].axes[0];
    scenario.commands.push_back({.joint = j,
                                 .kind = CommandKind::kPosition,
                                 .value = held_position(axis),
                                 .end = kHoldTime,
                                 .gains = hold_gains(loads, scene.joints[j]),
                                 .control = Control::kImplicit});
  }
  if (scenario.commands.empty()) return {{}, driven.why_none()};
  add_drive(wheels, 0, 0, {"", 0, kHoldTime}, 0, scenario);
  return {std::move(scenario), {}, effort_note(driven)};
}

}  // namespace rigor::simulate
