// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/test_parts.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor::simulate {
namespace {

/// Of the speed that the scene's size would give in free fall: what a robot with legs or wheels of this
/// size does easily (a Froude number of 0.18).
constexpr double kDriveShare = 0.3;

/// With a ramp of a second, a tenth of gravity: no robot tips that stands on its own.
constexpr double kDriveSpeed = 1;  // m/s

// s. Springs of robots swing at 2 Hz with a tenth of damping.
constexpr double kSettleTime = 1;
constexpr double kSprungSettleTime = 5;

bool held_by_brake(const Scene& scene, std::uint32_t j) {
  const SceneJoint& joint = scene.joints[j];
  return can_be_told(joint) && joint.child < scene.bodies.size() &&
         !(joint.axes[0].spring_stiffness > 0) && !rolls_freely(scene, j);
}

/// kg·m² (of a slider kg): how a body resists the axis when everything else gives way.
double own_inertia(const Scene& scene, const SceneJoint& joint, std::uint32_t b) {
  if (b >= scene.bodies.size()) return kInfinity;
  const SceneBody& body = scene.bodies[b];
  if (joint.type == model::JointType::kPrismatic) return body.mass.mass;
  const Vector3 axis = rotate(conjugate(body.X_WB.rotation), joint.axes[0].direction_W);
  const Vector3 anchor = transform(inverse(body.X_WB), joint.anchor_W);
  return mass::moment_about(axis, mass::about(anchor, body.mass));
}

/// N·m (of a slider N): what gravity does along the axis when the joint is so far from its start.
double gravity_effort(const Scene& scene, const SceneJoint& joint, double moved) {
  const Vector3& axis = joint.axes[0].direction_W;
  const bool slides = joint.type == model::JointType::kPrismatic;
  double sum = 0;
  for (const std::uint32_t b : carried_bodies(scene, joint.child)) {
    const SceneBody& body = scene.bodies[b];
    if (!body.gravity) continue;
    const Vector3 weight = body.mass.mass * scene.gravity;
    const Vector3 arm = transform(body.X_WB, body.mass.com) - joint.anchor_W;
    const Vector3 turned = slides ? arm : rotate(model::from_axis_angle(axis, moved), arm);
    sum += dot(axis, slides ? weight : cross(turned, weight));
  }
  return sum;
}

}  // namespace

bool is_wheel_joint(const DriveTrain& wheels, std::uint32_t joint) {
  const auto is = [&](const Wheel& wheel) { return wheel.joint == joint; };
  return std::any_of(wheels.left.begin(), wheels.left.end(), is) ||
         std::any_of(wheels.right.begin(), wheels.right.end(), is);
}

double settling_time(const Scene& scene) {
  const auto is_sprung = [](const SceneJoint& joint) {
    return std::any_of(joint.axes.begin(), joint.axes.end(),
                       [](const SceneAxis& axis) { return axis.spring_stiffness > 0; });
  };
  const bool sprung = std::any_of(scene.joints.begin(), scene.joints.end(), is_sprung);
  return sprung ? kSprungSettleTime : kSettleTime;
}

Phase rest_of(double begin, double end) { return {"rest", end - (end - begin) / 5, end}; }

bool can_be_told(const SceneJoint& joint) {
  const bool kind = joint.type == model::JointType::kRevolute ||
                    joint.type == model::JointType::kContinuous ||
                    joint.type == model::JointType::kPrismatic;
  return kind && joint.axes.size() == 1 && joint.mimics.empty();
}

void add_brakes(const Scene& scene, const DriveTrain& wheels, Scenario& scenario) {
  for (std::uint32_t j = 0; j < scene.joints.size(); ++j) {
    if (is_wheel_joint(wheels, j) || !held_by_brake(scene, j)) continue;
    scenario.commands.push_back(
        {.joint = j, .kind = CommandKind::kVelocity, .value = 0, .end = scenario.duration});
  }
}

double drive_speed(const Scene& scene, const DriveTrain& wheels) {
  const double falling = std::sqrt(2 * length(scene.gravity) * scene.size);
  double speed = std::min(kDriveSpeed, kDriveShare * falling);
  for (const auto* side : {&wheels.left, &wheels.right}) {
    for (const Wheel& wheel : *side) {
      const double limit = scene.joints[wheel.joint].axes[0].velocity;
      if (limit > 0) speed = std::min(speed, limit * wheel.radius);
    }
  }
  return speed;
}

void add_drive(const DriveTrain& wheels, double left, double right, const Phase& when, double ramp,
               Scenario& scenario) {
  const auto command = [&](const Wheel& wheel, double speed) {
    scenario.commands.push_back({.joint = wheel.joint,
                                 .kind = CommandKind::kVelocity,
                                 .value = wheel.sign * speed / wheel.radius,
                                 .begin = when.begin,
                                 .end = when.end,
                                 .ramp = ramp});
  };
  for (const Wheel& wheel : wheels.left) command(wheel, left);
  for (const Wheel& wheel : wheels.right) command(wheel, right);
}

double carried_inertia(const Scene& scene, const SceneJoint& joint) {
  const Vector3& axis = joint.axes[0].direction_W;
  double sum = 0;
  for (const std::uint32_t b : carried_bodies(scene, joint.child)) {
    const SceneBody& body = scene.bodies[b];
    if (joint.type == model::JointType::kPrismatic) {
      sum += body.mass.mass;
      continue;
    }
    const mass::MassProperties in_W = mass::transformed(body.X_WB, body.mass);
    sum += mass::moment_about(axis, mass::about(joint.anchor_W, in_W));
  }
  return sum;
}

double effective_inertia(const Scene& scene, const SceneJoint& joint) {
  return 1 /
         (1 / own_inertia(scene, joint, joint.child) + 1 / own_inertia(scene, joint, joint.parent));
}

double carried_load(const Scene& scene, const SceneJoint& joint) {
  return std::abs(gravity_effort(scene, joint, 0));
}

double sweep_effort(const Scene& scene, const SceneJoint& joint, const SweepMotion& motion) {
  const SceneAxis& axis = joint.axes[0];
  const auto load = [&](double position) {
    return gravity_effort(scene, joint, position - axis.start);
  };
  double most = std::max(std::abs(load(motion.least)), std::abs(load(motion.most)));
  if (joint.type != model::JointType::kPrismatic) {
    // The load is c cos q + s sin q.
    const double c = load(0);
    const double s = load(std::numbers::pi / 2);
    const double farthest = std::atan2(s, c);
    const double next =
        farthest + std::ceil((motion.least - farthest) / std::numbers::pi) * std::numbers::pi;
    if (next <= motion.most) most = std::hypot(c, s);
  }
  most += axis.damping * motion.speed;
  // It starts from, and stops at, each limit and where it began; there from both sides.
  const double push = carried_inertia(scene, joint) * motion.acceleration;
  most = std::max({most, std::abs(load(motion.least) - push), std::abs(load(motion.most) + push),
                   std::abs(load(axis.start)) + push});
  return most + axis.friction;
}

}  // namespace rigor::simulate
