// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests of joints: each driven from limit to limit, and all held by controllers against gravity.

#include <rigor/simulate/test/parts.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <rigor/simulate/joint_load.h>
#include <rigor/simulate/metric/parts.h>
#include <rigor/simulate/scene/joint_cycles.h>

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

/// s: what would take longer for its weak motor is told as briskly as the others, and found too weak.
constexpr double kStrokeLongest = 12;

constexpr double kStrokeRounding = 1e-9;

/// Of the effort that a joint's load leaves: the rest is for what moves along.
constexpr double kStartShare = 0.5;

/// Times what a joint of a loop needs by itself: friction of the others, and their weight.
constexpr double kLoopEffort = 3;

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
struct SweptJoint {
  std::uint32_t joint = 0;
  SweepRange range;
  double acceleration = kInfinity;  ///< rad/s², m/s², the most that it starts and stops with
  double effort = kInfinity;        ///< N·m, N, the most that it is given
};

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
double add_stroke(const SweptJoint& swept, double from, double to, double begin,
                  Scenario& scenario) {
  const double way = std::abs(to - from);
  // A motor that cannot start and stop faster takes its time.
  const double gentle = std::min(swept.range.speed, std::sqrt(swept.acceleration * way));
  const double speed = way / gentle <= kStrokeLongest ? gentle : swept.range.speed;
  const double cruise = way / speed;
  const double slow = speed / swept.acceleration;
  const bool is_slow = slow > kStrokeRamp && slow <= cruise * (1 + kStrokeRounding);
  const double ramp = is_slow ? std::min(slow, cruise) : std::min(kStrokeRamp, cruise / 2);
  const auto add = [&](CommandKind kind, double value, double start, double end, double rise) {
    scenario.commands.push_back({.joint = swept.joint,
                                 .kind = kind,
                                 .value = value,
                                 .begin = start,
                                 .end = end,
                                 .ramp = rise,
                                 .effort = swept.effort});
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
/// When each joint of a loop is swept: the others of it are free then, since none moves while they are held.
class LoopTimes {
 public:
  explicit LoopTimes(const Scene& scene) : cycles_(joint_cycles(scene)) {}

  bool is_in_loop(std::uint32_t joint) const { return cycles_[joint] != kWorld; }

  void take(std::uint32_t joint, double begin, double end) {
    if (is_in_loop(joint)) taken_[cycles_[joint]].push_back({begin, end});
  }

  /// Stands where it is, but for the time that it, or a joint of its loop, is swept.
  void add_stands(std::uint32_t joint, double begin, double end, Scenario& scenario) const {
    const auto taken = is_in_loop(joint) ? taken_.find(cycles_[joint]) : taken_.end();
    if (taken != taken_.end()) {
      for (const auto& [from, to] : taken->second) {  // one after the other
        if (to <= begin || from >= end) continue;
        add_stand(joint, begin, from, scenario);
        begin = to;
      }
    }
    add_stand(joint, begin, end, scenario);
  }

 private:
  std::vector<std::uint32_t> cycles_;
  std::map<std::uint32_t, std::vector<std::pair<double, double>>> taken_;
};

/// How a joint is swept. With half of the effort that its load leaves it starts and stops; in a loop, whose other joints
/// may stop it, it pushes with no more than a few times what it needs.
SweptJoint swept_joint(const JointLoads& loads, const Scene& scene, std::uint32_t index,
                       bool is_in_loop) {
  const SceneJoint& joint = scene.joints[index];
  SweptJoint swept{index, sweep_range(scene, joint)};
  const SweepRange& range = swept.range;
  const double load = loads.sweep_effort(joint, {range.lower, range.upper, range.speed, 0});
  const double left = joint.axes[0].effort - load;
  const double inertia = loads.inertia(joint);
  if (left > 0 && inertia > 0) swept.acceleration = kStartShare * left / inertia;
  if (is_in_loop) {
    const double started = load + inertia * range.speed / kStrokeRamp;
    swept.effort = kLoopEffort * started;
  }
  return swept;
}

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
  LoopTimes loops(scene);
  const JointLoads loads(scene);
  for (const std::uint32_t j : joints) {
    const SweptJoint one = swept_joint(loads, scene, j, loops.is_in_loop(j));
    const SweepRange& range = one.range;
    const double start = std::clamp(scene.joints[j].axes[0].start, range.lower, range.upper);
    const double begin = schedule.begin_of(scene.joints[j], settled);
    double time = begin;
    time = add_stroke(one, start, range.lower, time, scenario);
    time = add_stroke(one, range.lower, range.upper, time, scenario);
    time = add_stroke(one, range.upper, start, time, scenario);
    swept.push_back({"sweep " + scene.joints[j].name, begin, time});
    loops.take(j, begin, time);
    schedule.take(scene.joints[j], time);
    if (schedule.end() > kSweepMost) break;
  }
  const double time = schedule.end();
  scenario.duration = time;
  scenario.phases.insert(scenario.phases.end(), swept.begin(), swept.end());
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const bool is_swept = i < swept.size();
    loops.add_stands(joints[i], 0, is_swept ? swept[i].begin : time, scenario);
    if (is_swept) loops.add_stands(joints[i], swept[i].end, time, scenario);
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
