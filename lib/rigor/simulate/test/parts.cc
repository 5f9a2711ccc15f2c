// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/test/parts.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <rigor/simulate/joint_load.h>

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

bool can_be_held(const Scene& scene, const SceneJoint& joint) {
  return can_be_commanded(joint) && joint.child < scene.bodies.size() &&
         !(joint.axes[0].spring_stiffness > 0);
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

void add_brakes(const Scene& scene, const DriveTrain& wheels, Scenario& scenario) {
  const std::vector<bool> rolling = rolling_joints(scene);
  for (std::uint32_t j = 0; j < scene.joints.size(); ++j) {
    if (is_wheel_joint(wheels, j) || rolling[j] || !can_be_held(scene, scene.joints[j])) continue;
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

}  // namespace rigor::simulate
