// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/wheels.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <rigor/simulate/reach.h>
#include <rigor/simulate/round_shape.h>

namespace rigor::simulate {
namespace {

/// Sine of the angle that a wheel's axis may have with level ground: 15°. Camber is 1° to 10°.
constexpr double kLevelSine = 0.26;

/// An axis within 25° of upright steers, and no wheel rolls about it.
constexpr double kUprightCosine = 0.9;

/// A wheel's lowest point may be this share of its radius above the lowest of the model: one that
/// hangs in the air because a caster is too low is still a wheel. One on top of a robot is none.
constexpr double kReachShare = 0.25;

/// Of its radius: a disk that hangs beside its hinge by more is a pendulum.
constexpr double kOffAxisShare = 0.5;

/// Wheels of one drive have axes that are parallel to within 10°.
constexpr double kParallelCosine = 0.985;

/// A model's x is its forward when an axis is across it to within 45°.
constexpr double kAcrossCosine = 0.707;

/// As a share of the largest radius: wheels nearer to the middle than this are on no side.
constexpr double kMiddleShare = 0.1;

/// rad, sixteen turns: joints of real arms and legs have up to 40, endless ones that write limits 200.
constexpr double kEndlessTravel = 100;

double length_of_travel(const SceneAxis& axis) { return axis.upper - axis.lower; }

/// Whether a joint with an upright axis carries the body: a caster's fork, or a steered wheel's.
bool is_steered(const Scene& scene, std::uint32_t body) {
  return std::any_of(scene.joints.begin(), scene.joints.end(), [&](const SceneJoint& joint) {
    return joint.child == body && joint.parent != kWorld && !joint.axes.empty() &&
           joint.type != model::JointType::kPrismatic &&
           std::abs(joint.axes[0].direction_W.z) > kUprightCosine;
  });
}

Wheel wheel_of(const SceneJoint& joint, std::uint32_t index, std::uint32_t shape,
               const RoundShape& round) {
  const Vector3& axis = joint.axes[0].direction_W;
  const Vector3 along = dot(round.middle_W - joint.anchor_W, axis) * axis;
  return {.joint = index,
          .shape = shape,
          .radius = round.radius,
          .width = round.width,
          .centre_W = joint.anchor_W + along,
          .middle_W = round.middle_W,
          .shape_axis_W = round.axis_W};
}

/// Of the joint's child the round shape that reaches lowest.
std::optional<Wheel> lowest_round(const Scene& scene, std::uint32_t index) {
  const SceneJoint& joint = scene.joints[index];
  std::optional<Wheel> wheel;
  double lowest = kInfinity;
  for (std::uint32_t s = 0; s < scene.shapes.size(); ++s) {
    if (scene.shapes[s].body != joint.child) continue;
    const double bottom = -reach(scene, scene.shapes[s], {0, 0, -1});
    if (!(bottom < lowest)) continue;
    const std::optional<RoundShape> round =
        round_about(scene, scene.shapes[s], joint.axes[0].direction_W);
    if (!round) continue;
    lowest = bottom;
    wheel = wheel_of(joint, index, s, *round);
  }
  return wheel;
}

const Vector3& axis_of(const Scene& scene, const Wheel& wheel) {
  return scene.joints[wheel.joint].axes[0].direction_W;
}

/// What it looks like it rolls about: the shape's own axis where it has one. A joint's axis that is off
/// is a fault of a wheel, and makes it no other thing.
const Vector3& rolling_axis(const Scene& scene, const Wheel& wheel) {
  return length(wheel.shape_axis_W) > 0 ? wheel.shape_axis_W : axis_of(scene, wheel);
}

bool is_on_axis(const Wheel& wheel) {
  return length(wheel.middle_W - wheel.centre_W) < kOffAxisShare * wheel.radius;
}

bool drives(const Scene& scene, const Wheel& wheel, double lowest) {
  const SceneJoint& joint = scene.joints[wheel.joint];
  const SceneShape& shape = scene.shapes[wheel.shape];
  const double bottom = -reach(scene, shape, {0, 0, -1});
  return std::abs(rolling_axis(scene, wheel).z) < kLevelSine && is_on_axis(wheel) &&
         !is_steered(scene, joint.parent) && bottom - lowest < kReachShare * wheel.radius;
}

/// Whether a joint that turns on and on has a wheel on it that stands on the ground, or is a fork whose
/// wheel is no link of its own.
bool stands_on_wheel(const Scene& scene, std::uint32_t index, double ground) {
  const SceneJoint& joint = scene.joints[index];
  if (!can_turn_over(joint)) return false;
  if (std::abs(joint.axes[0].direction_W.z) > kUprightCosine) {
    return std::any_of(scene.shapes.begin(), scene.shapes.end(), [&](const SceneShape& shape) {
      return shape.body == joint.child && -reach(scene, shape, {0, 0, -1}) < ground;
    });
  }
  const std::optional<Wheel> wheel = lowest_round(scene, index);
  return wheel && is_on_axis(*wheel) &&
         -reach(scene, scene.shapes[wheel->shape], {0, 0, -1}) < ground;
}

bool is_among(const std::vector<std::string>& names, const SceneJoint& joint) {
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return is_named(joint.name, name); });
}

std::vector<Wheel> candidates(const Scene& scene, const std::vector<std::string>& named) {
  std::vector<Wheel> found;
  std::vector<double> lowest;  // of each model
  for (std::uint32_t m = 0; m < scene.models.size(); ++m) {
    lowest.push_back(lowest_of_model(scene, m));
  }
  for (std::uint32_t i = 0; i < scene.joints.size(); ++i) {
    const SceneJoint& joint = scene.joints[i];
    if (joint.child >= scene.bodies.size() || joint.parent >= scene.bodies.size()) continue;
    if (joint.axes.empty() || joint.type == model::JointType::kPrismatic) continue;
    if (std::abs(joint.axes[0].direction_W.z) > kUprightCosine) continue;
    if (named.empty() ? !can_turn_over(joint) : !is_among(named, joint)) continue;
    const std::optional<Wheel> wheel = lowest_round(scene, i);
    if (wheel && (!named.empty() || drives(scene, *wheel, lowest[scene.bodies[joint.child].model])))
      found.push_back(*wheel);
  }
  return found;
}

std::uint32_t model_of(const Scene& scene, const Wheel& wheel) {
  return scene.bodies[scene.joints[wheel.joint].child].model;
}

/// Of the candidates those of the model and direction that most of them have.
std::vector<Wheel> largest_parallel_group(const Scene& scene, const std::vector<Wheel>& all) {
  std::vector<Wheel> best;
  for (const Wheel& leader : all) {
    std::vector<Wheel> group;
    for (const Wheel& wheel : all) {
      if (model_of(scene, wheel) == model_of(scene, leader) &&
          std::abs(dot(rolling_axis(scene, wheel), rolling_axis(scene, leader))) >
              kParallelCosine) {
        group.push_back(wheel);
      }
    }
    if (group.size() > best.size()) best = std::move(group);
  }
  return best;
}

Vector3 forward_across(const Vector3& axis, const Quaternion& R_WB) {
  Vector3 forward = cross(axis, {0, 0, 1});
  forward = (1 / length(forward)) * forward;
  const double along_x = dot(forward, rotate(R_WB, {1, 0, 0}));
  const double along_y = dot(forward, rotate(R_WB, {0, 1, 0}));
  const double ahead = std::abs(along_x) > kAcrossCosine ? along_x : along_y;
  return ahead < 0 ? -1 * forward : forward;
}

void sort_into_sides(const Scene& scene, std::vector<Wheel> wheels, DriveTrain& train) {
  const Vector3 to_left = cross({0, 0, 1}, train.forward_W);
  double least = kInfinity;
  double most = -kInfinity;
  double largest = 0;
  for (Wheel& wheel : wheels) {
    const double side = dot(wheel.middle_W, to_left);
    least = std::min(least, side);
    most = std::max(most, side);
    largest = std::max(largest, wheel.radius);
    wheel.sign = dot(cross(axis_of(scene, wheel), {0, 0, 1}), train.forward_W) < 0 ? -1 : 1;
  }
  const bool in_a_row = most - least < kMiddleShare * largest;
  double left = 0;
  double right = 0;
  for (const Wheel& wheel : wheels) {
    const double side = dot(wheel.middle_W, to_left);
    const bool is_left = in_a_row || side > (least + most) / 2;
    (is_left ? train.left : train.right).push_back(wheel);
    (is_left ? left : right) += side;
  }
  if (train.right.empty()) return;
  train.track = left / static_cast<double>(train.left.size()) -
                right / static_cast<double>(train.right.size());
}

void add_casters(const Scene& scene, DriveTrain& train) {
  const double lowest = lowest_of_model(scene, train.model);
  const auto rolls = [&](std::uint32_t shape) {
    const auto is = [&](const Wheel& wheel) { return wheel.shape == shape; };
    return std::any_of(train.left.begin(), train.left.end(), is) ||
           std::any_of(train.right.begin(), train.right.end(), is);
  };
  for (std::uint32_t s = 0; s < scene.shapes.size(); ++s) {
    const SceneShape& shape = scene.shapes[s];
    if (shape.body >= scene.bodies.size() || scene.bodies[shape.body].model != train.model)
      continue;
    if (!rolls(s) && -reach(scene, shape, {0, 0, -1}) < lowest + kTouchGap) {
      train.casters.push_back(s);
    }
  }
}

void add_steering(const Scene& scene, DriveTrain& train) {
  const double lowest = lowest_of_model(scene, train.model);
  for (std::uint32_t j = 0; j < scene.joints.size(); ++j) {
    const SceneJoint& joint = scene.joints[j];
    if (joint.model != train.model || joint.child >= scene.bodies.size()) continue;
    if (joint.axes.empty() || std::abs(joint.axes[0].direction_W.z) < kUprightCosine) continue;
    if (joint.type == model::JointType::kPrismatic || can_turn_over(joint)) continue;
    if (touches_ground(scene, joint.child, lowest + kTouchGap)) train.steering.push_back(j);
  }
}

}  // namespace

std::vector<std::uint32_t> carried_bodies(const Scene& scene, std::uint32_t body) {
  std::vector<std::uint32_t> all{body};
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const SceneJoint& joint : scene.joints) {
      if (joint.parent != all[i] || joint.child >= scene.bodies.size()) continue;
      if (std::find(all.begin(), all.end(), joint.child) == all.end()) all.push_back(joint.child);
    }
  }
  return all;
}

bool can_turn_over(const SceneJoint& joint) {
  return joint.type == model::JointType::kContinuous ||
         (joint.type == model::JointType::kRevolute && !joint.axes.empty() &&
          length_of_travel(joint.axes[0]) > kEndlessTravel);
}

bool rolls_freely(const Scene& scene, std::uint32_t joint) {
  const std::uint32_t child = scene.joints[joint].child;
  if (child >= scene.bodies.size() || !can_turn_over(scene.joints[joint])) return false;
  const double ground = lowest_of_model(scene, scene.bodies[child].model) + kTouchGap;
  const std::vector<std::uint32_t> carried = carried_bodies(scene, child);
  for (std::uint32_t j = 0; j < scene.joints.size(); ++j) {
    const bool carries = j == joint || std::find(carried.begin(), carried.end(),
                                                 scene.joints[j].parent) != carried.end();
    if (carries && scene.joints[j].child < scene.bodies.size() &&
        stands_on_wheel(scene, j, ground)) {
      return true;
    }
  }
  return false;
}

bool touches_ground(const Scene& scene, std::uint32_t body, double height) {
  const std::vector<std::uint32_t> carried = carried_bodies(scene, body);
  return std::any_of(scene.shapes.begin(), scene.shapes.end(), [&](const SceneShape& shape) {
    return std::find(carried.begin(), carried.end(), shape.body) != carried.end() &&
           -reach(scene, shape, {0, 0, -1}) < height;
  });
}

DriveTrain find_wheels(const Scene& scene, const std::vector<std::string>& named) {
  DriveTrain train{.named = !named.empty()};
  const std::vector<Wheel> wheels = largest_parallel_group(scene, candidates(scene, named));
  if (wheels.empty()) return train;
  train.model = model_of(scene, wheels.front());
  const std::uint32_t base = scene.models[train.model].base;
  const Quaternion R_WB =
      base < scene.bodies.size() ? scene.bodies[base].X_WB.rotation : Quaternion{};
  train.forward_W = forward_across(rolling_axis(scene, wheels.front()), R_WB);
  sort_into_sides(scene, wheels, train);
  add_casters(scene, train);
  add_steering(scene, train);
  return train;
}

}  // namespace rigor::simulate
