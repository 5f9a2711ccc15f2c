// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which joints of a model drive it: revolute joints without limits (or with very wide ones), whose
// axis is level, whose child has a round shape about that axis that reaches the ground.
//
//   DriveTrain train = find_wheels(scene, {});
//   if (train.empty()) say_why(train);

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

struct Wheel {
  std::uint32_t joint = 0;
  std::uint32_t shape = kWorld;  ///< that rolls
  double radius = 0;             ///< m, of the circle that rolls (of a mesh, its outline over 2 pi)
  double width = 0;              ///< m, of the line it touches the ground along; 0 for a ball
  Vector3 center_W;              ///< at the start: where the axis is nearest the shape's middle
  Vector3 middle_W;  ///< of the shape itself; off the axis where the wheel is off center
  /// The shape's own axis of rotation, a unit vector; zero for a ball.
  Vector3 shape_axis_W;
  /// +1 when a positive velocity rolls it forward.
  double sign = 1;
};

struct DriveTrain {
  std::uint32_t model = kWorld;  ///< index in the scene
  Vector3 forward_W{1, 0,
                    0};     ///< level unit vector, across the axes: the model's x where that fits
  std::vector<Wheel> left;  ///< seen along `forward_W`
  std::vector<Wheel> right;
  double track = 0;                    ///< m, between the middles of left and right
  std::vector<std::uint32_t> casters;  ///< other shapes that touch the ground
  /// Joints with an upright axis and limits that carry a round shape which touches the ground.
  std::vector<std::uint32_t> steering;

  bool named = false;  ///< the user said which joints are wheels

  /// Whether it turns on the spot when its sides run against each other.
  bool steers() const { return !left.empty() && !right.empty() && track > 0; }
  bool empty() const { return left.empty() && right.empty(); }
};

/// `named` are joints that the user says are wheels, by name; else they are found.
DriveTrain find_wheels(const Scene& scene, const std::vector<std::string>& named);

/// What looks like a wheel, about a level axis, and cannot drive: it is too high, or its joint stops it.
struct IdleWheel {
  std::uint32_t joint = 0;
  double above = 0;           ///< m, above the lowest point of the model; 0 of one that touches
  double travel = kInfinity;  ///< rad, that its joint has
};

/// Of the wheels of a train those above the ground; of a model without one, also what stops or is higher.
std::vector<IdleWheel> idle_wheels(const Scene& scene, const DriveTrain& train);

/// A shape touches the ground when it is not higher than this above the lowest point of the model:
/// what contacts sink in, and the care with which models are drawn.
inline constexpr double kTouchGap = 0.003;  // m

/// Wheels are on one axle when one is not farther ahead of the other than this share of its radius.
inline constexpr double kAxleShare = 0.5;

/// Whether a hinge may turn on and on: without limits, or with limits that are far apart. What joints
/// of arms and legs may travel, a few turns, is not.
bool can_turn_over(const SceneJoint& joint);

/// Of each joint whether the ground may turn it: that of a wheel which stands on it, or one that turns on
/// and on and carries such a wheel, as a caster's fork does.
std::vector<bool> rolling_joints(const Scene& scene);

}  // namespace rigor::simulate
