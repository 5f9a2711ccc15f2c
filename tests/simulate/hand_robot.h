// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The robot of Gazebo's tutorial as a scene made by hand, with masses as if it were solid: 5 kg of
// chassis, wheels of 0.5 kg. For tests of what needs no file.

#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include <rigor/simulate/scene/scene.h>

namespace rigor::hand {

inline simulate::SceneShape shape_of(std::uint32_t body, simulate::SceneShapeKind kind,
                                     const model::Pose& X_BS = {}) {
  simulate::SceneShape shape;
  shape.body = body;
  shape.kind = std::move(kind);
  shape.X_BS = X_BS;
  return shape;
}

/// Moments of a solid cylinder along z: m (3 r² + l²)/12 across it, m r²/2 about it.
inline mass::MassProperties cylinder_mass(double mass, double radius, double length) {
  const double across = mass * (3 * radius * radius + length * length) / 12;
  return {mass, {}, {across, 0, 0, across, 0, mass * radius * radius / 2}};
}

inline simulate::SceneJoint hinge(std::string name, std::uint32_t parent, std::uint32_t child,
                                  const model::Vector3& anchor, const model::Vector3& axis) {
  simulate::SceneJoint joint;
  joint.name = std::move(name);
  joint.parent = parent;
  joint.child = child;
  joint.anchor_W = anchor;
  joint.axes.emplace_back();
  joint.axes[0].direction_W = axis;
  joint.model = 0;
  return joint;
}

/// Bodies 0 chassis, 1 left wheel, 2 right wheel; shapes 0 box, 1 caster, 2 and 3 wheels.
inline simulate::Scene tutorial_robot() {
  simulate::Scene scene;
  scene.size = std::sqrt(0.4 * 0.4 + 0.31 * 0.31 + 0.2 * 0.2);
  scene.models.push_back({.name = "my_robot", .base = 0});
  simulate::SceneBody chassis;
  chassis.name = "my_robot::chassis";
  chassis.X_WB.translation = {0, 0, 0.1};
  chassis.mass = {5, {}, {5 * 0.05 / 12, 0, 0, 5 * 0.17 / 12, 0, 5 * 0.2 / 12}};
  simulate::SceneBody wheel;
  wheel.mass = cylinder_mass(0.5, 0.1, 0.05);
  const double quarter = std::numbers::pi / 2;
  simulate::SceneBody left = wheel;
  left.name = "my_robot::left_wheel";
  left.X_WB = {{0.1, 0.13, 0.1}, model::from_rpy(0, quarter, quarter)};
  simulate::SceneBody right = wheel;
  right.name = "my_robot::right_wheel";
  right.X_WB = {{0.1, -0.13, 0.1}, model::from_rpy(0, quarter, quarter)};
  scene.bodies = {chassis, left, right};
  scene.shapes.push_back(shape_of(0, mesh::Box{{0.4, 0.2, 0.1}}));
  scene.shapes.push_back(shape_of(0, mesh::Sphere{0.05}, {{-0.15, 0, -0.05}, {}}));
  scene.shapes[1].surface.mu = scene.shapes[1].surface.mu2 = 0;
  scene.shapes.push_back(shape_of(1, mesh::Cylinder{0.1, 0.05}));
  scene.shapes.push_back(shape_of(2, mesh::Cylinder{0.1, 0.05}));
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    scene.shapes[i].name = "shape " + std::to_string(i);
  }
  scene.joints.push_back(hinge("my_robot::left_wheel_hinge", 0, 1, {0.1, 0.10, 0.1}, {0, 1, 0}));
  scene.joints.push_back(hinge("my_robot::right_wheel_hinge", 0, 2, {0.1, -0.10, 0.1}, {0, 1, 0}));
  for (std::uint32_t i = 0; i < scene.bodies.size(); ++i) {
    scene.bodies[i].links = {i};
    simulate::SceneLink link;
    link.name = scene.bodies[i].name;
    link.body = i;
    scene.links.push_back(link);
  }
  return scene;
}

}  // namespace rigor::hand
