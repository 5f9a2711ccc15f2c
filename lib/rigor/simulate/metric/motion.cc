// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Metrics of a whole run: where it began, how fast anything got, whether energy came from nowhere.

#include <rigor/simulate/metric/parts.h>

#include <algorithm>
#include <cmath>

#include <rigor/simulate/reach.h>

namespace rigor::simulate {
namespace {

/// A shape may be this share of its extent in the ground, if that is more than 5 mm: a lorry may.
constexpr double kSunkShare = 0.01;

double commanded_speed_of(const Scene& scene, const DriveTrain& wheels, const Command& command) {
  const bool slides = scene.joints[command.joint].type == model::JointType::kPrismatic;
  double arm = slides ? 1 : scene.size;
  for (const auto* side : {&wheels.left, &wheels.right}) {
    for (const Wheel& wheel : *side) {
      // The rim of a wheel is twice as fast as its center.
      if (wheel.joint == command.joint) arm = 2 * wheel.radius;
    }
  }
  if (command.kind == CommandKind::kVelocity) return std::abs(command.value) * arm;
  const double limit = scene.joints[command.joint].axes[command.axis].velocity;
  const double rate = command.ramp > 0 ? 2 * std::abs(command.value) / command.ramp : kInfinity;
  return std::min(rate, limit) * arm;
}

/// m/s: of a fall from where the highest body is, through the scene's size; and of what is commanded.
/// Infinite where a command's effort, or a slope, may lead to any speed.
double expected_speed(const MetricSheet& sheet) {
  if (!sheet.scenario.tilts.empty()) return kInfinity;
  double height = sheet.scene.size + sheet.scenario.drop;
  double highest = 0;
  for (const SceneBody& body : sheet.scene.bodies) {
    highest = std::max(highest, transform(body.X_WB, body.mass.com).z);
  }
  height += highest;
  double commanded = 0;
  for (const Command& command : sheet.scenario.commands) {
    if (command.kind == CommandKind::kEffort) return kInfinity;
    commanded = std::max(commanded, commanded_speed_of(sheet.scene, sheet.wheels, command));
  }
  for (const Push& push : sheet.scenario.pushes) {
    commanded += length(push.impulse_W) / sheet.scene.bodies[push.body].mass.mass;
  }
  return std::sqrt(2 * gravity_scale(sheet.scene) * height) + commanded;
}

}  // namespace

void add_spawn_metrics(MetricSheet& sheet) {
  const Scene& scene = sheet.scene;
  const Measures& measures = sheet.record.measures;
  const Peak& sunk = measures.spawn_penetration;
  const double extent = sunk.of < scene.shapes.size() ? scene.shapes[sunk.of].extent : 0;
  const double scale = std::isfinite(extent) ? std::max(1.0, kSunkShare * extent / 0.005) : 1;
  sheet.add("spawn.penetration", sunk.value, about_shape(scene, sunk.of), scale);
  const Peak& overlap = measures.spawn_overlap;
  Fact pair = about_shape(scene, overlap.of);
  pair.name = about_shape(scene, measures.spawn_overlap_with).subject;
  sheet.add("spawn.self_overlap", overlap.value, std::move(pair));
  for (std::uint32_t m = 0; m < scene.models.size() && sheet.scenario.gravity; ++m) {
    const Footing& footing = sheet.footings[m];
    if (footing.kind != Footing::Kind::kInTheAir) continue;
    sheet.add("spawn.gap", footing.gap, about_model(scene, m));
  }
  if (!scene.alone || sheet.scenario.spawn == Spawn::kOnGround || !sheet.scenario.ground ||
      sheet.scenario.drop > 0) {
    return;
  }
  for (std::uint32_t m = 0; m < scene.models.size(); ++m) {
    const double gap = stands_free(scene, m) ? lowest_of_model(scene, m) : kInfinity;
    if (std::isfinite(gap)) sheet.add("spawn.gap", std::max(0.0, gap), about_model(scene, m));
  }
}

void add_motion_metrics(MetricSheet& sheet) {
  Peak speed, acceleration, energy, tilt, self;
  std::uint32_t self_with = kWorld;
  for (const PhaseMeasures& phase : sheet.record.measures.phases) {
    speed.see(phase.speed.value, phase.speed.of, 0);
    acceleration.see(phase.acceleration.value, phase.acceleration.of, 0);
    energy.see(phase.energy.value, phase.energy.of, 0);
    tilt.see(phase.tilt.value, phase.tilt.of, 0);
    if (phase.self_contact.value > self.value) self_with = phase.self_contact_with;
    self.see(phase.self_contact.value, phase.self_contact.of, 0);
  }
  const Scene& scene = sheet.scene;
  const double g = gravity_scale(scene);
  sheet.add("speed.peak", speed.value / expected_speed(sheet), about_body(scene, speed.of));
  // What a push does is no chatter, nor what happens to that which fell off a table.
  if (sheet.scenario.pushes.empty() && sheet.scenario.tilts.empty()) {
    sheet.add("accel.peak", acceleration.value / g, about_body(scene, acceleration.of));
  }
  const double whole = moving_mass(scene) * g * scene.size;
  if (whole > 0) sheet.add("energy.gain", energy.value / whole, about_scene(scene));
  const bool meant = !sheet.scenario.tilts.empty() || !sheet.scenario.pushes.empty();
  if (!meant) sheet.add("tilt.max", tilt.value, about_model(scene, tilt.of));
  Fact pair = about_shape(scene, self.of);
  pair.name = about_shape(scene, self_with).subject;
  sheet.add("selfcollide.depth", self.value, std::move(pair));
}

}  // namespace rigor::simulate
