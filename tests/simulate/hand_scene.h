// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Scenes made by hand, for tests of the engine.

#pragma once

#include <cstdint>
#include <string>

#include <rigor/mesh/primitive/primitive_mesh.h>
#include <rigor/simulate/engine/engine.h>
#include <rigor/simulate/scene/scene.h>

namespace rigor::hand {

using simulate::kWorld;
using simulate::Scene;
using simulate::Vector3;

inline mass::MassProperties ball_mass(double mass, double radius) {
  const double i = 0.4 * mass * radius * radius;
  return {.mass = mass, .com = {}, .about_com = {.ixx = i, .iyy = i, .izz = i}};
}

inline mass::MassProperties box_mass(double mass, const Vector3& s) {
  const auto moment = [mass](double a, double b) { return mass * (a * a + b * b) / 12; };
  return {.mass = mass,
          .com = {},
          .about_com = {.ixx = moment(s.y, s.z), .iyy = moment(s.x, s.z), .izz = moment(s.x, s.y)}};
}

/// Its axis along z.
inline mass::MassProperties drum_mass(double mass, double radius, double length) {
  const double across = mass * (3 * radius * radius + length * length) / 12;
  return {.mass = mass,
          .com = {},
          .about_com = {.ixx = across, .iyy = across, .izz = mass * radius * radius / 2}};
}

inline Scene scene() {
  Scene scene;
  scene.name = "hand";
  scene.models.push_back({.name = "robot", .base = 0});
  return scene;
}

inline std::uint32_t add_body(Scene& scene, const mass::MassProperties& mass, const Vector3& p,
                              const simulate::Quaternion& R = {}) {
  const auto index = static_cast<std::uint32_t>(scene.bodies.size());
  const std::string name = "robot::link" + std::to_string(index);
  scene.bodies.push_back({.name = name,
                          .links = {static_cast<std::uint32_t>(scene.links.size())},
                          .mass = mass,
                          .X_WB = {p, R}});
  scene.links.push_back({.name = name, .body = index, .model = 0});
  return index;
}

inline simulate::SceneShape& add_shape(Scene& scene, std::uint32_t body,
                                       const simulate::SceneShapeKind& kind,
                                       const simulate::Pose& X_BS = {}) {
  simulate::SceneShape shape{.name = "shape" + std::to_string(scene.shapes.size()),
                             .body = body,
                             .X_BS = X_BS,
                             .kind = kind,
                             .extent = 1};
  if (body != kWorld) shape.link = scene.bodies[body].links.front();
  scene.shapes.push_back(shape);
  return scene.shapes.back();
}

inline simulate::SceneShape& add_ground(Scene& scene) {
  return add_shape(scene, kWorld, simulate::HalfSpace{});
}

inline std::uint32_t add_joint(Scene& scene, model::JointType type, std::uint32_t parent,
                               std::uint32_t child, const Vector3& anchor,
                               const std::vector<Vector3>& axes) {
  const auto index = static_cast<std::uint32_t>(scene.joints.size());
  simulate::SceneJoint joint{.name = "robot::joint" + std::to_string(index),
                             .type = type,
                             .parent = parent,
                             .child = child,
                             .anchor_W = anchor};
  for (const Vector3& axis : axes) joint.axes.push_back({.direction_W = axis});
  joint.model = 0;
  scene.joints.push_back(joint);
  return index;
}

/// What the closed forms were measured with: nothing gives way.
inline simulate::SolverSettings stiff() {
  simulate::SolverSettings settings;
  settings.cfm = 0;
  return settings;
}

}  // namespace rigor::hand
