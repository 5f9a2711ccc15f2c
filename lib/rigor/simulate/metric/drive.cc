// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Metrics of a robot that drives: of the phases "drive", "cruise", "arc", "spin", "run-up", "brake".

#include <rigor/simulate/metric/parts.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <rigor/simulate/run.h>

namespace rigor::simulate {
namespace {

/// Wheels that rolled less than this have no ratio to speak of.
constexpr double kMinWay = 0.01;  // m

/// Wheels of one side whose middles are farther apart than this share of their radius skid in a turn,
/// and nothing but friction says how far it turns: then it should only turn at all.
constexpr double kSkidShare = 0.1;
constexpr double kSkidLeast = 0.1;

/// m: how far the wheels of a side rolled, forward positive, in the mean.
double rolled(const Scene& scene, const std::vector<Wheel>& side, const PhaseMeasures& phase) {
  if (side.empty()) return 0;
  const std::vector<std::uint32_t> first = first_axes(scene);
  double sum = 0;
  for (const Wheel& wheel : side) {
    sum += wheel.sign * wheel.radius * phase.axis_path[first[wheel.joint]];
  }
  return sum / static_cast<double>(side.size());
}

/// m: how far the wheels rolled in the mean, whichever way.
double rolled_any_way(const MetricSheet& sheet, const PhaseMeasures& phase) {
  double sum = 0;
  double count = 0;
  for (const auto* side : {&sheet.wheels.left, &sheet.wheels.right}) {
    for (const Wheel& wheel : *side) {
      sum += std::abs(rolled(sheet.scene, {wheel}, phase));
      ++count;
    }
  }
  return sum / count;
}

/// m: how far they would have rolled in the phase "drive", as commanded.
double told_to_roll(const MetricSheet& sheet) {
  const auto is_drive = [](const Phase& phase) { return phase.name == "drive"; };
  const std::vector<Phase>& phases = sheet.scenario.phases;
  const double begin = std::find_if(phases.begin(), phases.end(), is_drive)->begin;
  double sum = 0;
  double count = 0;
  for (const auto* side : {&sheet.wheels.left, &sheet.wheels.right}) {
    for (const Wheel& wheel : *side) {
      for (const Command& command : sheet.scenario.commands) {
        if (command.joint != wheel.joint || command.begin != begin) continue;
        if (command.kind != CommandKind::kVelocity) continue;
        const double seconds = command.end - command.begin - command.ramp / 2;
        sum += wheel.radius * std::abs(command.value) * seconds;
        ++count;
      }
    }
  }
  return count > 0 ? sum / count : 0;
}

bool drives_with(const MetricSheet& sheet) {
  return !sheet.wheels.empty() && sheet.wheels.model < sheet.scene.models.size() &&
         sheet.scene.models[sheet.wheels.model].base < sheet.scene.bodies.size();
}

std::uint32_t base_of(const MetricSheet& sheet) {
  return sheet.scene.models[sheet.wheels.model].base;
}

/// Forward as the robot stood when the phase began, level.
Vector3 forward_at(const MetricSheet& sheet, const PhaseMeasures& phase) {
  const std::uint32_t base = base_of(sheet);
  const Quaternion R_BW = conjugate(sheet.scene.bodies[base].X_WB.rotation);
  Vector3 forward = rotate(phase.begin[base].R_WB, rotate(R_BW, sheet.wheels.forward_W));
  forward.z = 0;
  const double size = length(forward);
  return size > 0 ? (1 / size) * forward : sheet.wheels.forward_W;
}

/// The joint of the wheel that rolled least.
std::uint32_t laziest_joint(const MetricSheet& sheet, const PhaseMeasures& phase) {
  std::uint32_t joint = kWorld;
  double least = kInfinity;
  for (const auto* side : {&sheet.wheels.left, &sheet.wheels.right}) {
    for (const Wheel& wheel : *side) {
      const double way = std::abs(rolled(sheet.scene, {wheel}, phase));
      if (way < least) {
        least = way;
        joint = wheel.joint;
      }
    }
  }
  return joint;
}

Fact about_laziest(const MetricSheet& sheet, const PhaseMeasures& phase) {
  return about_joint(sheet.scene, laziest_joint(sheet, phase));
}

/// A limit of zero is no limit that is too low: nothing turns the wheel.
void blame_zero_limit(const Scene& scene, std::uint32_t joint, Metric& reached) {
  if (!reached.fact || joint == kWorld) return;
  const SceneAxis& axis = scene.joints[joint].axes[0];
  if (axis.effort > 0 && axis.velocity > 0) return;
  const std::string which = axis.effort > 0 ? "velocity" : "effort";
  reached.fact->name = which + " limit of 0";
  if (!axis.limit_where.nowhere()) reached.fact->where = axis.limit_where;
  reached.fact->help = "set the `" + which + "` of its limit to what the motor can do";
}

/// The way ahead, or of the wheel that turns most against it, as shares of what the wheels roll.
void add_direction(MetricSheet& sheet, const PhaseMeasures& phase, double ahead, double wheels) {
  double least = ahead / wheels;
  Fact about = about_model(sheet.scene, sheet.wheels.model);
  for (const auto* side : {&sheet.wheels.left, &sheet.wheels.right}) {
    for (const Wheel& wheel : *side) {
      const double forward = rolled(sheet.scene, {wheel}, phase) / wheels;
      if (!(forward < std::min(least, 0.0))) continue;
      least = forward;
      about = about_joint(sheet.scene, wheel.joint);
    }
  }
  sheet.add("drive.direction", least, std::move(about));
}

void add_drive_bounce(MetricSheet& sheet, const Fact& about) {
  const PhaseMeasures* cruise = sheet.phase("cruise");
  if (cruise == nullptr) return;
  const double square = cruise->vertical_square[sheet.wheels.model];
  sheet.add("drive.bounce", std::sqrt(square / static_cast<double>(cruise->steps)), about);
}

bool skids(const MetricSheet& sheet) {
  for (const auto* side : {&sheet.wheels.left, &sheet.wheels.right}) {
    for (const Wheel& wheel : *side) {
      const Vector3 apart = wheel.center_W - side->front().center_W;
      if (std::abs(dot(apart, sheet.wheels.forward_W)) > kSkidShare * wheel.radius) return true;
    }
  }
  return false;
}

/// How far a turn is outside of the band that the wheels' width leaves open, as a share.
double beyond_band(double ratio, double track, double width) {
  const double least = track / (track + width);
  const double most = width < track ? track / (track - width) : kInfinity;
  if (ratio < least) return 1 - ratio / least;
  return ratio > most ? ratio / most - 1 : 0;
}

double widest(const DriveTrain& wheels) {
  double width = 0;
  for (const auto* side : {&wheels.left, &wheels.right}) {
    for (const Wheel& wheel : *side) width = std::max(width, wheel.width);
  }
  return width;
}

/// A pyramid resists across a wheel with all of its friction while the wheel pushes along with as much again: what
/// is longer than wide may not turn on it, and does on a cone (MuJoCo turns what is stuck here at 0.2 to 0.7 of the
/// way).
void forgive_pyramid(Metric& metric) {
  if (!metric.fact) return;
  metric.fact->help =
      "its wheels skid as it turns, which the friction pyramid of ODE resists more than the cone "
      "of "
      "other engines";
  if (metric.verdict != Verdict::kFail) return;
  metric.verdict = Verdict::kWarn;
  metric.fact->severe = false;
  metric.fact->limit = *metric.warn;
}

void add_turn(MetricSheet& sheet, std::string_view phase_name, std::string_view id) {
  const PhaseMeasures* phase = sheet.phase(phase_name);
  if (phase == nullptr) return;
  const double apart = rolled(sheet.scene, sheet.wheels.right, *phase) -
                       rolled(sheet.scene, sheet.wheels.left, *phase);
  // Wheels that do not turn do not turn the model either.
  if (std::abs(apart) < kMinWay) return sheet.add(id, 1, about_laziest(sheet, *phase));
  const double track = sheet.wheels.track;
  const double ratio = phase->yaw_path[sheet.wheels.model] / (apart / track);
  // Wheels that skid anyway: a turn of a tenth will do, and what is missing of that is reported.
  const bool skidding = skids(sheet);
  const double off = skidding ? std::max(0.0, 1 - ratio / kSkidLeast)
                              : beyond_band(ratio, track, widest(sheet.wheels));
  sheet.add(id, off, about_model(sheet.scene, sheet.wheels.model));
  if (skidding) forgive_pyramid(sheet.metrics.back());
}

}  // namespace

void add_drive_metrics(MetricSheet& sheet) {
  const PhaseMeasures* drive = sheet.phase("drive");
  if (drive == nullptr || !drives_with(sheet)) return;
  const Fact about = about_model(sheet.scene, sheet.wheels.model);
  const std::uint32_t base = base_of(sheet);
  const Vector3 way = drive->end[base].p_WBcm - drive->begin[base].p_WBcm;
  const Vector3 forward = forward_at(sheet, *drive);
  const double ahead = dot(way, forward);
  const double aside = dot(way, cross({0, 0, 1}, forward));
  const double wheels = rolled_any_way(sheet, *drive);
  const double told = told_to_roll(sheet);
  if (told > 0) {
    sheet.add("drive.reached", wheels / told, about_laziest(sheet, *drive));
    blame_zero_limit(sheet.scene, laziest_joint(sheet, *drive), sheet.metrics.back());
  }
  if (wheels > kMinWay) {
    add_direction(sheet, *drive, ahead, wheels);
    sheet.add("drive.ratio", std::abs(std::hypot(ahead, aside) / wheels - 1), about);
  }
  if (std::abs(ahead) > kMinWay) {
    sheet.add("drive.lateral", std::abs(aside / ahead), about);
    sheet.add("drive.yaw", std::abs(drive->yaw_path[sheet.wheels.model]), about);
  }
  add_drive_bounce(sheet, about);
}

void add_turn_metrics(MetricSheet& sheet) {
  if (!drives_with(sheet) || !sheet.wheels.steers()) return;
  add_turn(sheet, "arc", "turn.arc");
  add_turn(sheet, "spin", "turn.spin");
}

void add_brake_metrics(MetricSheet& sheet) {
  const PhaseMeasures* brake = sheet.phase("brake");
  if (brake == nullptr || !drives_with(sheet)) return;
  const std::uint32_t base = base_of(sheet);
  const double before = length(brake->begin[base].v_WBcm);
  if (!(before > kSettledSpeed)) return;
  sheet.add("brake.speed", length(brake->end[base].v_WBcm) / before,
            about_model(sheet.scene, sheet.wheels.model));
}

void add_push_metrics(MetricSheet& sheet) {
  const PhaseMeasures* push = sheet.phase("push");
  if (push == nullptr || sheet.scenario.pushes.empty()) return;
  const std::uint32_t model = sheet.scene.bodies[sheet.scenario.pushes[0].body].model;
  const std::uint32_t base = sheet.scene.models[model].base;
  if (base >= push->end.size() || !sheet.stands(model)) return;
  sheet.add("push.tilt", tilt_since_start(sheet.scene, model, push->end[base]),
            about_model(sheet.scene, model));
}

}  // namespace rigor::simulate
