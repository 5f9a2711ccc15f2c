// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/wheels.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <rigor/simulate/joint_load.h>
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

/// Of its radius: what is higher above the ground is no wheel that misses it, but a pulley.
constexpr double kMissShare = 1;

/// rad: a wheel that was given the limits of an arm's joint, ±π or so. What turns less is a finger, a flap or a foot.
constexpr double kLimitedTravel = 3;

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
          .center_W = joint.anchor_W + along,
          .middle_W = round.middle_W,
          .shape_axis_W = round.axis_W};
}

/// Of the joint's child the round shape that reaches lowest.
std::optional<Wheel> lowest_round(const Scene& scene, const LowestPoints& lowest,
                                  std::uint32_t index) {
  const SceneJoint& joint = scene.joints[index];
  std::optional<Wheel> wheel;
  double least = kInfinity;
  for (std::uint32_t s = 0; s < scene.shapes.size(); ++s) {
    if (scene.shapes[s].body != joint.child || !(lowest.of_shape[s] < least)) continue;
    const std::optional<RoundShape> round =
        round_about(scene, scene.shapes[s], joint.axes[0].direction_W);
    if (!round) continue;
    least = lowest.of_shape[s];
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
  return length(wheel.middle_W - wheel.center_W) < kOffAxisShare * wheel.radius;
}

bool drives(const Scene& scene, const LowestPoints& lowest, const Wheel& wheel) {
  const SceneJoint& joint = scene.joints[wheel.joint];
  const double above =
      lowest.of_shape[wheel.shape] - lowest.of_model[scene.bodies[joint.child].model];
  return std::abs(rolling_axis(scene, wheel).z) < kLevelSine && is_on_axis(wheel) &&
         !is_steered(scene, joint.parent) && above < kReachShare * wheel.radius;
}

/// m: how low what rolls about a joint that turns on and on reaches: a wheel, or a fork whose wheel is no
/// link of its own. Infinity when there is none.
double bottom_of_wheel(const Scene& scene, const LowestPoints& lowest, std::uint32_t index) {
  const SceneJoint& joint = scene.joints[index];
  if (joint.child >= scene.bodies.size() || !can_turn_over(joint)) return kInfinity;
  if (std::abs(joint.axes[0].direction_W.z) > kUprightCosine) return lowest.of_body[joint.child];
  const std::optional<Wheel> wheel = lowest_round(scene, lowest, index);
  return wheel && is_on_axis(*wheel) ? lowest.of_shape[wheel->shape] : kInfinity;
}

bool is_among(const std::vector<std::string>& names, const SceneJoint& joint) {
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return is_named(joint.name, name); });
}

std::vector<Wheel> candidates(const Scene& scene, const LowestPoints& lowest,
                              const std::vector<std::string>& named) {
  std::vector<Wheel> found;
  for (std::uint32_t i = 0; i < scene.joints.size(); ++i) {
    const SceneJoint& joint = scene.joints[i];
    if (joint.child >= scene.bodies.size() || joint.parent >= scene.bodies.size()) continue;
    if (joint.axes.empty() || joint.type == model::JointType::kPrismatic) continue;
    if (std::abs(joint.axes[0].direction_W.z) > kUprightCosine) continue;
    if (named.empty() ? !can_turn_over(joint) : !is_among(named, joint)) continue;
    const std::optional<Wheel> wheel = lowest_round(scene, lowest, i);
    if (wheel && (!named.empty() || drives(scene, lowest, *wheel))) found.push_back(*wheel);
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

/// Ahead is x by convention (REP 103). Of a model that is drawn along its y nothing says which way it faces: it is
/// the way that most wheels roll at a positive velocity.
bool faces_backward(const Scene& scene, const std::vector<Wheel>& wheels, const Vector3& forward_W,
                    const Quaternion& R_WB) {
  if (std::abs(dot(forward_W, rotate(R_WB, {1, 0, 0}))) > kAcrossCosine) return false;
  int ahead = 0;
  for (const Wheel& wheel : wheels) {
    ahead += dot(cross(axis_of(scene, wheel), {0, 0, 1}), forward_W) < 0 ? -1 : 1;
  }
  return ahead < 0;
}

/// Whether it carries nothing: what does is a link of an arm or a leg.
bool is_last(const Scene& scene, std::uint32_t body) {
  return std::none_of(scene.joints.begin(), scene.joints.end(),
                      [&](const SceneJoint& joint) { return joint.parent == body; });
}

/// m
double height_of(const Scene& scene, const LowestPoints& lowest, const Wheel& wheel) {
  return lowest.of_shape[wheel.shape] -
         lowest.of_model[scene.bodies[scene.joints[wheel.joint].child].model];
}

/// What is round about a level axis at its middle, and near the ground, whether or not it can roll there.
std::vector<Wheel> like_wheels(const Scene& scene, const LowestPoints& lowest) {
  std::vector<Wheel> found;
  for (std::uint32_t i = 0; i < scene.joints.size(); ++i) {
    const SceneJoint& joint = scene.joints[i];
    const bool turns =
        joint.type == model::JointType::kRevolute || joint.type == model::JointType::kContinuous;
    if (!turns || joint.axes.size() != 1 || !joint.mimics.empty()) continue;
    if (joint.child >= scene.bodies.size() || joint.parent >= scene.bodies.size()) continue;
    if (std::abs(joint.axes[0].direction_W.z) > kLevelSine || !is_last(scene, joint.child))
      continue;
    if (length_of_travel(joint.axes[0]) < kLimitedTravel) continue;
    const std::optional<Wheel> wheel = lowest_round(scene, lowest, i);
    const bool rolls = wheel && wheel->width > 0 && wheel->width < 2 * wheel->radius &&
                       std::abs(wheel->shape_axis_W.z) < kLevelSine && is_on_axis(*wheel) &&
                       !is_steered(scene, joint.parent);
    if (rolls && height_of(scene, lowest, *wheel) < kMissShare * wheel->radius) {
      found.push_back(*wheel);
    }
  }
  return found;
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

void add_casters(const Scene& scene, const LowestPoints& lowest, DriveTrain& train) {
  const double ground = lowest.of_model[train.model] + kTouchGap;
  const auto rolls = [&](std::uint32_t shape) {
    const auto is = [&](const Wheel& wheel) { return wheel.shape == shape; };
    return std::any_of(train.left.begin(), train.left.end(), is) ||
           std::any_of(train.right.begin(), train.right.end(), is);
  };
  for (std::uint32_t s = 0; s < scene.shapes.size(); ++s) {
    const SceneShape& shape = scene.shapes[s];
    if (shape.body >= scene.bodies.size() || scene.bodies[shape.body].model != train.model)
      continue;
    if (!rolls(s) && lowest.of_shape[s] < ground) train.casters.push_back(s);
  }
}

void add_steering(const Scene& scene, const LowestPoints& lowest, DriveTrain& train) {
  const double ground = lowest.of_model[train.model] + kTouchGap;
  const CarriedBodies carried(scene);
  for (std::uint32_t j = 0; j < scene.joints.size(); ++j) {
    const SceneJoint& joint = scene.joints[j];
    if (joint.model != train.model || joint.child >= scene.bodies.size()) continue;
    if (joint.axes.empty() || std::abs(joint.axes[0].direction_W.z) < kUprightCosine) continue;
    if (joint.type == model::JointType::kPrismatic || can_turn_over(joint)) continue;
    const std::vector<std::uint32_t> bodies = carried.by(joint.child);
    const bool stands = std::any_of(bodies.begin(), bodies.end(), [&](std::uint32_t body) {
      return lowest.of_body[body] < ground;
    });
    if (stands) train.steering.push_back(j);
  }
}

}  // namespace

bool can_turn_over(const SceneJoint& joint) {
  return joint.type == model::JointType::kContinuous ||
         (joint.type == model::JointType::kRevolute && !joint.axes.empty() &&
          length_of_travel(joint.axes[0]) > kEndlessTravel);
}

std::vector<bool> rolling_joints(const Scene& scene) {
  std::vector<bool> rolling(scene.joints.size());
  if (std::none_of(scene.joints.begin(), scene.joints.end(), can_turn_over)) return rolling;
  const LowestPoints lowest(scene);
  const CarriedBodies carried(scene);
  std::vector<double> bottoms;
  for (std::uint32_t j = 0; j < scene.joints.size(); ++j) {
    bottoms.push_back(bottom_of_wheel(scene, lowest, j));
  }
  for (std::uint32_t j = 0; j < scene.joints.size(); ++j) {
    const std::uint32_t child = scene.joints[j].child;
    if (child >= scene.bodies.size() || !can_turn_over(scene.joints[j])) continue;
    double bottom = bottoms[j];
    for (const std::uint32_t body : carried.by(child)) {
      for (const std::uint32_t k : carried.joints_on(body)) bottom = std::min(bottom, bottoms[k]);
    }
    rolling[j] = bottom < lowest.of_model[scene.bodies[child].model] + kTouchGap;
  }
  return rolling;
}

std::vector<IdleWheel> idle_wheels(const Scene& scene, const DriveTrain& train) {
  std::vector<IdleWheel> idle;
  if (!scene.alone) return idle;
  const LowestPoints lowest(scene);
  std::vector<Wheel> wheels = train.left;
  wheels.insert(wheels.end(), train.right.begin(), train.right.end());
  if (train.empty()) wheels = largest_parallel_group(scene, like_wheels(scene, lowest));
  if (wheels.size() < 2) return idle;  // a pulley, or a crank
  for (const Wheel& wheel : wheels) {
    const double above = height_of(scene, lowest, wheel);
    const SceneJoint& joint = scene.joints[wheel.joint];
    const bool misses = above > kTouchGap;
    if (!misses && can_turn_over(joint)) return {};  // one drives
    idle.push_back({wheel.joint, misses ? above : 0,
                    can_turn_over(joint) ? kInfinity : length_of_travel(joint.axes[0])});
  }
  return idle;
}

DriveTrain find_wheels(const Scene& scene, const std::vector<std::string>& named) {
  DriveTrain train{.named = !named.empty()};
  const LowestPoints lowest(scene);
  const std::vector<Wheel> wheels = largest_parallel_group(scene, candidates(scene, lowest, named));
  if (wheels.empty()) return train;
  train.model = model_of(scene, wheels.front());
  const std::uint32_t base = scene.models[train.model].base;
  const Quaternion R_WB =
      base < scene.bodies.size() ? scene.bodies[base].X_WB.rotation : Quaternion{};
  train.forward_W = forward_across(rolling_axis(scene, wheels.front()), R_WB);
  if (faces_backward(scene, wheels, train.forward_W, R_WB)) train.forward_W = -1 * train.forward_W;
  sort_into_sides(scene, wheels, train);
  add_casters(scene, lowest, train);
  add_steering(scene, lowest, train);
  return train;
}

}  // namespace rigor::simulate
