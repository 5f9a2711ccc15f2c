// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/assembled/axles.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace rigor::robot {
namespace {

using model::Vector3;

// 18°: no camber is larger.
constexpr double kAlongAxis = 0.95;
// A shape farther off the axis, as a share of its radius, swings rather than rolls.
constexpr double kOffCenter = 0.2;
// Sides of the box around a round mesh.
constexpr double kSquare = 0.03;

/// As the parts of an arm do, and wheels do not.
bool holds_up(const Assembled& robot, std::uint32_t a, std::uint32_t b) {
  const Links all = robot.subtree(a);
  return std::find(all.begin(), all.end(), b) != all.end();
}

}  // namespace

std::optional<double> radius_about(const AssembledShape& shape, const model::Shape& of,
                                   const Vector3& axis_W) {
  const OrientedBox& box = shape.box_W;
  std::size_t along = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (std::abs(dot(box.axes_W[k], axis_W)) > std::abs(dot(box.axes_W[along], axis_W))) along = k;
  }
  if (std::holds_alternative<model::Sphere>(of)) return box.half[0];
  if (std::abs(dot(box.axes_W[along], axis_W)) < kAlongAxis) return std::nullopt;
  const double p = box.half[(along + 1) % 3];
  const double q = box.half[(along + 2) % 3];
  const bool round =
      std::holds_alternative<model::Cylinder>(of) || std::holds_alternative<model::Capsule>(of);
  if (round && along != 2) return std::nullopt;
  if (!round && !std::holds_alternative<model::Mesh>(of)) return std::nullopt;
  if (std::abs(p - q) > kSquare * std::max(p, q)) return std::nullopt;
  return std::max(p, q);
}

bool turns_on_and_on(const model::Joint& joint) {
  if (joint.type == model::JointType::kContinuous) return true;
  if (joint.type != model::JointType::kRevolute || joint.axes.empty()) return false;
  const model::Axis& axis = joint.axes.front();
  if (!axis.lower.written || !axis.upper.written) return true;
  constexpr double kManyTurns = 10 * 2 * std::numbers::pi;
  return axis.upper.value - axis.lower.value > kManyTurns;
}

std::vector<Wheel> wheels(const model::Root& root, const model::Frames& frames,
                          const Assembled& robot) {
  std::vector<Wheel> result;
  for (std::uint32_t j = 0; j < root.joints.size(); ++j) {
    const model::Joint& joint = root.joints[j];
    if (joint.axes.empty() || !turns_on_and_on(joint)) continue;
    const auto& ends = frames.ends({j});
    const auto axis_W = frames.axis({j}, 0);
    const auto X_WJ = frames.pose(model::Id<model::Joint>{j});
    if (!ends.child || !axis_W || !X_WJ) continue;
    Wheel wheel{ends.child.value, j, *axis_W, {}, {}, {}, 0};
    for (const std::uint32_t s : robot.links[wheel.link].shapes) {
      const AssembledShape& shape = robot.shapes[s];
      const bool touched = shape.role == ShapeRole::kCollision;
      const model::Shape& of = touched ? root.collisions[shape.index].geometry.shape
                                       : root.visuals[shape.index].geometry.shape;
      const auto radius = radius_about(shape, of, *axis_W);
      if (!radius) continue;
      const Vector3 arm = shape.box_W.center_W - X_WJ->translation;
      if (model::length(arm - dot(arm, *axis_W) * *axis_W) > kOffCenter * *radius) continue;
      auto& known = touched ? wheel.collision_radius : wheel.visual_radius;
      if (known && *known >= *radius) continue;
      known = radius;
      if (!touched && wheel.collision_radius) continue;
      wheel.shape = s;
      wheel.center_W = shape.box_W.center_W;
    }
    if (wheel.radius() > 0) result.push_back(wheel);
  }
  return result;
}

std::vector<Axle> axles(const std::vector<Wheel>& wheels, const Assembled& robot) {
  constexpr double kParallel = 0.99;
  constexpr double kLevel = 0.5;
  constexpr double kBeside = 0.25;  // of the larger radius: both on the ground, of two sizes
  std::vector<Axle> result;
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    for (std::size_t j = i + 1; j < wheels.size(); ++j) {
      const Wheel& a = wheels[i];
      const Wheel& b = wheels[j];
      if (robot.links[a.link].top != robot.links[b.link].top) continue;
      if (std::abs(dot(a.axis_W, b.axis_W)) < kParallel || std::abs(a.axis_W.z) > kLevel) continue;
      if (holds_up(robot, a.link, b.link) || holds_up(robot, b.link, a.link)) continue;
      const Vector3 between = b.center_W - a.center_W;
      const double along = std::abs(dot(between, a.axis_W));
      const double off = model::length(between - dot(between, a.axis_W) * a.axis_W);
      const double larger = std::max(a.radius(), b.radius());
      if (off < kBeside * larger && along > larger / 2) result.push_back({i, j});
    }
  }
  return result;
}

}  // namespace rigor::robot
