// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests of a robot that is not commanded to move: settle, drop, push, tilt-table.

#include <rigor/simulate/test/parts.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include <rigor/simulate/footprint.h>

namespace rigor::simulate {
namespace {

/// Of the size of the scene: what a robot survives that slips from somebody's hands.
constexpr double kDropShare = 0.1;

/// How long to wait after a push.
constexpr double kRecoverTime = 2;  // s

/// Of the momentum that the whole would have after it fell through its own size.
constexpr double kPushShare = 0.2;

/// Slow enough to be in balance all the time: 5°/s.
constexpr double kTiltRate = 0.0873;  // rad/s

/// The table goes on this far beyond the angle at which it should tip: 10°; and never beyond 60°.
constexpr double kTiltBeyond = 0.1745;
constexpr double kTiltMost = 1.047;

/// Sine of the angle that the axis of a drum may have with level ground: what leans more stands on its edge.
constexpr double kLying = 0.1;

std::uint32_t first_moving_model(const Scene& scene) {
  for (std::uint32_t m = 0; m < scene.models.size(); ++m) {
    if (!scene.models[m].is_static && scene.models[m].base < scene.bodies.size()) return m;
  }
  return kWorld;
}

/// A ball, or what is round and lies on its side: a push or a slope rolls it, and no lean of it is a fall.
bool rolls_away(const Scene& scene, std::uint32_t model) {
  const SceneShape* only = nullptr;
  for (const SceneShape& shape : scene.shapes) {
    if (shape.body >= scene.bodies.size() || scene.bodies[shape.body].model != model) continue;
    if (only != nullptr) return false;
    only = &shape;
  }
  if (only == nullptr) return false;
  if (std::holds_alternative<mesh::Sphere>(only->kind)) return true;
  const bool is_drum = std::holds_alternative<mesh::Cylinder>(only->kind) ||
                       std::holds_alternative<mesh::Capsule>(only->kind);
  const Quaternion R_WS = compose(scene.bodies[only->body].X_WB, only->X_BS).rotation;
  return is_drum && std::abs(rotate(R_WS, {0, 0, 1}).z) < kLying;
}

constexpr const char* kRolls = "it is round and rolls";

Vector3 sideways(const DriveTrain& wheels) {
  return wheels.empty() ? Vector3{1, 0, 0} : cross({0, 0, 1}, wheels.forward_W);
}

}  // namespace

MadeTest make_settle(const Scene& scene, const DriveTrain& wheels) {
  const double settled = settling_time(scene);
  Scenario scenario{.name = "settle", .duration = settled};
  scenario.phases = {{"settle", 0, settled}, rest_of(0, settled)};
  add_brakes(scene, wheels, scenario);
  return {std::move(scenario), {}};
}

MadeTest make_drop(const Scene& scene, const DriveTrain& wheels) {
  const double g = length(scene.gravity);
  if (!(g > 0)) return {{}, "there is no gravity to drop it by"};
  Scenario scenario{.name = "drop", .spawn = Spawn::kOnGround, .drop = kDropShare * scene.size};
  const double fall = std::sqrt(2 * scenario.drop / g);
  scenario.duration = fall + settling_time(scene) + 1;
  scenario.phases = {{"drop", 0, scenario.duration}, rest_of(fall, scenario.duration)};
  add_brakes(scene, wheels, scenario);
  return {std::move(scenario), {}};
}

MadeTest make_push(const Scene& scene, const DriveTrain& wheels) {
  const std::uint32_t model = wheels.empty() ? first_moving_model(scene) : wheels.model;
  if (model == kWorld) return {{}, "the base of no model moves"};
  if (rolls_away(scene, model)) return {{}, kRolls};
  const std::uint32_t base = scene.models[model].base;
  Scenario scenario{.name = "push", .spawn = Spawn::kOnGround};
  const double settled = settling_time(scene);
  const double end = settled + kRecoverTime;
  scenario.duration = end;
  scenario.phases = {{"settle", 0, settled}, {"push", settled, end}};
  double mass = 0;
  for (const SceneBody& body : scene.bodies) mass += body.model == model ? body.mass.mass : 0;
  const double falling = std::sqrt(2 * length(scene.gravity) * scene.size);
  const Vector3 center = center_of_mass(scene, model);
  scenario.pushes.push_back({.body = base,
                             .impulse_W = kPushShare * mass * falling * sideways(wheels),
                             .p_BP = transform(inverse(scene.bodies[base].X_WB), center),
                             .at = settled});
  add_brakes(scene, wheels, scenario);
  add_drive(wheels, 0, 0, {"", 0, end}, 0, scenario);
  return {std::move(scenario), {}};
}

MadeTest make_tilt_table(const Scene& scene, const DriveTrain& wheels) {
  const std::uint32_t model = wheels.empty() ? first_moving_model(scene) : wheels.model;
  if (model == kWorld) return {{}, "the base of no model moves"};
  if (rolls_away(scene, model)) return {{}, kRolls};
  const std::vector<Vector3> corners = footprint_at_start(scene, model, kFootSlack);
  if (corners.size() < 3) return {{}, "it stands on a line or a point"};
  const TiltOver tip = tip_angle(scene, model, corners);
  if (!(tip.angle > 0)) return {{}, "its center of mass is not above what it stands on"};
  const double most = std::min(kTiltMost, tip.angle + kTiltBeyond);
  Scenario scenario{.name = "tilt-table", .spawn = Spawn::kOnGround};
  const double settled = settling_time(scene);
  scenario.duration = settled + most / kTiltRate;
  scenario.phases = {{"settle", 0, settled}, {"tilt", settled, scenario.duration}};
  // Turning about u × z, gravity gets a part along u.
  scenario.tilts.push_back({.begin = settled,
                            .end = scenario.duration,
                            .angle = most,
                            .axis = cross(tip.outward, {0, 0, 1})});
  add_brakes(scene, wheels, scenario);
  add_drive(wheels, 0, 0, {"", 0, scenario.duration}, 0, scenario);
  return {std::move(scenario), {}};
}

}  // namespace rigor::simulate
