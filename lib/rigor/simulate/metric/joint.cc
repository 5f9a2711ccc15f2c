// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Metrics of joints: whether they hold together and keep their limits, reach what they are commanded to, and
// hold it.

#include <rigor/simulate/metric/parts.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include <rigor/simulate/footprint.h>
#include <rigor/simulate/joint_load.h>
#include <rigor/simulate/run.h>
#include <rigor/simulate/scene/joint_cycles.h>

namespace rigor::simulate {
namespace {

/// All of a joint's effort, but for rounding.
constexpr double kAllEffort = 0.999;

/// "sweep robot::elbow": the phase in which the test joint-sweep moves that joint.
constexpr std::string_view kSweepPhase = "sweep ";

/// Of its way: a joint that is stopped, or too weak to get there.
constexpr double kMissed = 0.01;

void add_controller_margin(MetricSheet& sheet) {
  const double step = sheet.scene.solver.step;
  Peak margin;
  for (const Command& command : sheet.scenario.commands) {
    const SceneJoint& joint = sheet.scene.joints[command.joint];
    const bool steps = command.gains && command.control == Control::kExplicit;
    if (!steps || joint.axes.size() != 1) continue;
    const double inertia = effective_inertia(sheet.scene, joint);
    margin.see(command.gains->d * step / inertia, command.joint, 0);
  }
  if (margin.of != kWorld) {
    sheet.add("joint.pd_margin", margin.value, about_joint(sheet.scene, margin.of));
  }
}

Peak largest(const Record& record, Peak PhaseMeasures::*what) {
  Peak all;
  for (const PhaseMeasures& phase : record.measures.phases) {
    all.see((phase.*what).value, (phase.*what).of, 0);
  }
  return all;
}

/// What is missing of the way from `least` to `most`, as a share of it.
double missing_share(double least, double most, double reached_least, double reached_most) {
  const double missing = std::max(0.0, reached_least - least) + std::max(0.0, most - reached_most);
  return most > least ? missing / (most - least) : 0;
}

struct Sweep {
  std::uint32_t joint = kWorld;
  SweepMotion motion{.least = kInfinity, .most = -kInfinity};
};

/// What a phase of a joint-sweep told to its joint. Phases of other joints may be at the same time.
Sweep swept_in(const Scene& scene, const Scenario& scenario, const Phase& phase) {
  Sweep sweep;
  const std::string_view swept = std::string_view(phase.name).substr(kSweepPhase.size());
  for (const Command& command : scenario.commands) {
    const bool inside = command.begin >= phase.begin && command.end <= phase.end;
    if (!inside || scene.joints[command.joint].name != swept) continue;
    SweepMotion& motion = sweep.motion;
    if (command.kind == CommandKind::kPosition) {
      sweep.joint = command.joint;
      motion.least = std::min(motion.least, command.value);
      motion.most = std::max(motion.most, command.value);
    } else if (command.kind == CommandKind::kVelocity) {
      const double speed = std::abs(command.value);
      motion.speed = std::max(motion.speed, speed);
      if (command.ramp > 0)
        motion.acceleration = std::max(motion.acceleration, speed / command.ramp);
    }
  }
  return sweep;
}

/// What a sweep takes of the joint's effort limit. The engine's motor gives no more than the limit: of one
/// that gave it all, or missed so much of its way, the need is computed. Nor does it feel the friction.
double effort_share(const SceneJoint& joint, const JointLoads& loads, const SweepMotion& motion,
                    double given, double missing) {
  const SceneAxis& axis = joint.axes[0];
  if (!(axis.effort > 0)) return 0;
  const bool weak = given >= kAllEffort || missing > kMissed;
  const double needed =
      weak ? loads.sweep_effort(joint, motion) : axis.friction + axis.damping * motion.speed;
  return std::max(given, needed / axis.effort);
}

/// A joint that has given all it has is too weak; else it is stopped by something.
void blame_effort(MetricSheet& sheet, bool exhausted) {
  Metric& metric = sheet.metrics.back();
  if (metric.fact && exhausted) metric.fact->kind = FactKind::kJointOverloaded;
}

/// Whether it sinks to its stop, where it rests without an effort.
bool is_too_weak_for_its_load(const Scene& scene, const SceneJoint& joint) {
  if (joint.axes.size() != 1 || !can_be_commanded(joint)) return false;
  const double effort = joint.axes[0].effort;
  return effort > 0 && JointLoads(scene).standing(joint) > effort;
}

/// Limits of an arm are those of its motors, and within them its links meet: no fault, but worth knowing. What is in the way
/// explains it, and not an inertia.
void blame_what_touches(const Scene& scene, const PhaseMeasures& seen, Metric& reach) {
  if (!reach.fact) return;
  reach.fact->help =
      about_shape(scene, seen.self_contact.of).subject + " and " +
      about_shape(scene, seen.self_contact_with).subject +
      " meet on the way: limit the joint to where they do not, or make these collisions smaller";
  if (reach.verdict != Verdict::kFail) return;
  reach.verdict = Verdict::kWarn;
  reach.fact->severe = false;
  reach.fact->limit = *reach.warn;
}

/// The range of a joint without limits is the sweep's: how much of it a loop leaves is how the mechanism is made.
bool has_range(const SceneJoint& joint, bool is_in_loop) {
  const SceneAxis& axis = joint.axes[0];
  return !is_in_loop || (axis.lower > -kInfinity && axis.upper < kInfinity);
}

void blame_loop(Metric& reach) {
  if (!reach.fact) return;
  reach.fact->help =
      "the other joints of its closed loop stop it: set its limits to what the loop leaves";
}

}  // namespace

void add_joint_metrics(MetricSheet& sheet) {
  const Scene& scene = sheet.scene;
  if (scene.joints.empty()) return;
  const Peak anchor = largest(sheet.record, &PhaseMeasures::anchor_error);
  sheet.add("joint.anchor_error", anchor.value, about_joint(scene, anchor.of),
            std::max(1.0, scene.size));
  const Peak limit = largest(sheet.record, &PhaseMeasures::limit_violation);
  sheet.add("joint.limit_violation", limit.value, about_axis(scene, limit.of));
  add_controller_margin(sheet);
}

void add_sweep_metrics(MetricSheet& sheet) {
  const std::vector<std::uint32_t> first = first_axes(sheet.scene);
  const JointLoads loads(sheet.scene);
  const std::vector<std::uint32_t> cycles = joint_cycles(sheet.scene);
  Peak reach, effort;
  bool exhausted = false;
  const PhaseMeasures* blocked = nullptr;  // in which its own links are in the way
  for (std::size_t i = 0; i < sheet.scenario.phases.size(); ++i) {
    const Phase& phase = sheet.scenario.phases[i];
    if (!phase.name.starts_with(kSweepPhase)) continue;
    const Sweep sweep = swept_in(sheet.scene, sheet.scenario, phase);
    const PhaseMeasures& seen = sheet.record.measures.phases[i];
    if (sweep.joint == kWorld || seen.steps == 0) continue;
    const std::uint32_t axis = first[sweep.joint];
    const double missing = has_range(sheet.scene.joints[sweep.joint], cycles[sweep.joint] != kWorld)
                               ? missing_share(sweep.motion.least, sweep.motion.most,
                                               seen.axis_min[axis], seen.axis_max[axis])
                               : 0;
    const double share = effort_share(sheet.scene.joints[sweep.joint], loads, sweep.motion,
                                      seen.axis_effort[axis], missing);
    const bool touches_itself = seen.self_contact.value > 0;
    if (missing > reach.value) {
      exhausted = share >= kAllEffort && !touches_itself;
      blocked = touches_itself ? &seen : nullptr;
    }
    reach.see(missing, sweep.joint, 0);
    if (!touches_itself) effort.see(share, sweep.joint, 0);
    if (reach.of == kWorld) reach.of = sweep.joint;
  }
  if (reach.of == kWorld) return;
  sheet.add("joint.reach", reach.value, about_joint(sheet.scene, reach.of));
  blame_effort(sheet, exhausted);
  if (!exhausted && cycles[reach.of] != kWorld) blame_loop(sheet.metrics.back());
  if (blocked != nullptr) blame_what_touches(sheet.scene, *blocked, sheet.metrics.back());
  if (effort.of == kWorld) return;
  sheet.add("joint.effort", effort.value, about_joint(sheet.scene, effort.of));
}

void add_hold_metrics(MetricSheet& sheet) {
  const PhaseMeasures* hold = sheet.phase("hold");
  if (hold == nullptr) return;
  const std::vector<std::uint32_t> first = first_axes(sheet.scene);
  Peak error;
  std::uint32_t joint = kWorld;  // of the error
  for (const Command& command : sheet.scenario.commands) {
    if (command.kind != CommandKind::kPosition) continue;
    const std::uint32_t axis = first[command.joint] + command.axis;
    const double off =
        std::max(hold->axis_max[axis] - command.value, command.value - hold->axis_min[axis]);
    if (off > error.value) joint = command.joint;
    error.see(off, axis, 0);
  }
  sheet.add("hold.error", error.value, about_axis(sheet.scene, error.of));
  if (joint == kWorld) return;
  blame_effort(sheet, hold->axis_effort[error.of] >= kAllEffort ||
                          is_too_weak_for_its_load(sheet.scene, sheet.scene.joints[joint]));
}

void add_tilt_table_metrics(MetricSheet& sheet) {
  const PhaseMeasures* tilt = sheet.phase("tilt");
  if (tilt == nullptr || sheet.scenario.tilts.empty()) return;
  const Scene& scene = sheet.scene;
  std::uint32_t model = sheet.wheels.empty() ? 0 : sheet.wheels.model;
  while (model < scene.models.size() && !stands_free(scene, model)) ++model;
  if (model >= scene.models.size()) return;
  const std::vector<Vector3> corners = footprint_at_start(scene, model, kFootSlack);
  const double expected = corners.size() < 3 ? 0 : tip_angle(scene, model, corners).angle;
  if (!(expected > 0)) return;
  // A table that reached its end without a fall has shown at least that angle.
  const Tilt& table = sheet.scenario.tilts[0];
  const double at = std::min(tilt->tipped, table.end);
  const double angle = table.angle * (at - table.begin) / (table.end - table.begin);
  sheet.add("tilt-table.angle",
            tilt->tipped < kInfinity ? angle / expected : std::max(1.0, angle / expected),
            about_model(scene, model));
}

}  // namespace rigor::simulate
