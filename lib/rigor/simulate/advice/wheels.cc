// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Causes in what a robot rolls on.

#include <rigor/simulate/advice/parts.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <rigor/simulate/metric/parts.h>
#include <rigor/simulate/round_shape.h>

namespace rigor::simulate {
namespace {

/// Of the radius: a wheel that is 1 % off center lifts the robot by that at each turn.
constexpr double kOffCenterShare = 0.01;
constexpr double kOffCenterSevere = 3;

/// The tutorial's own pi/2, written 1.5707, is 0.0001 off.
constexpr double kAxisAngle = 0.0175;  // rad, 1°
constexpr double kAxisSevere = 2;

/// Of a shape that has to slide when the robot turns.
constexpr double kCasterMu = 0.1;
constexpr double kCasterSevere = 2;

/// The test drive speeds up with a tenth of gravity: with less friction a wheel that bears its part of the
/// weight spins.
constexpr double kWheelMu = 0.1;
constexpr double kMinWheelMu = 1e-3;  // in a division

/// Of the larger radius. Two wheels that turn alike with 1 % between them turn a robot by a tenth of a
/// radian for each ten tracks of way.
constexpr double kRadiiShare = 0.01;
constexpr double kRadiiSevere = 5;

void add_friction(Causes& causes, const Wheel& wheel) {
  const ContactSurface& surface = causes.scene.shapes[wheel.shape].surface;
  // A wheel with rollers has friction in one direction only.
  const double mu = std::max(surface.mu, surface.mu2);
  if (mu >= kWheelMu) return;
  // Robots that a plugin moves have such wheels on purpose: no fault by itself.
  causes.add(FactKind::kCauseWheelFriction, about_shape(causes.scene, wheel.shape), mu, kWheelMu,
             kWheelMu / std::max(mu, kMinWheelMu), kInfinity);
}

/// Of each two wheels of an axle the smaller one.
void add_radii(Causes& causes) {
  const Scene& scene = causes.scene;
  for (const Wheel& left : causes.wheels.left) {
    for (const Wheel& right : causes.wheels.right) {
      const Wheel& small = left.radius < right.radius ? left : right;
      const Wheel& large = left.radius < right.radius ? right : left;
      const double ahead = dot(small.center_W - large.center_W, causes.wheels.forward_W);
      const double share = (large.radius - small.radius) / large.radius;
      if (std::abs(ahead) > kAxleShare * large.radius || share <= kRadiiShare) continue;
      Fact about = about_shape(scene, small.shape);
      about.name = about_shape(scene, large.shape).subject;
      causes.add(FactKind::kCauseWheelRadii, std::move(about), small.radius, large.radius,
                 share / kRadiiShare, kRadiiSevere);
    }
  }
}

void add_geometry(Causes& causes, const Wheel& wheel) {
  const Scene& scene = causes.scene;
  Fact about = about_joint(scene, wheel.joint);
  about.name = about_shape(scene, wheel.shape).subject;
  const double off = length(wheel.middle_W - wheel.center_W);
  const double most = kOffCenterShare * wheel.radius;
  if (off > most) {
    causes.add(FactKind::kCauseWheelOffCenter, about, off, most, off / most, kOffCenterSevere);
  }
  const Vector3& axis = scene.joints[wheel.joint].axes[0].direction_W;
  const double angle =
      std::atan2(length(cross(axis, wheel.shape_axis_W)), std::abs(dot(axis, wheel.shape_axis_W)));
  if (length(wheel.shape_axis_W) > 0 && angle > kAxisAngle) {
    about.name = "tilted";
    causes.add(FactKind::kCauseWheelAxis, about, angle, kAxisAngle, angle / kAxisAngle,
               kAxisSevere);
  }
  const SceneShape& shape = scene.shapes[wheel.shape];
  if (std::holds_alternative<TriangleSoup>(shape.kind) ||
      std::holds_alternative<ConvexHull>(shape.kind)) {
    causes.add(FactKind::kCauseMeshWheel, about_shape(scene, wheel.shape), 1, 0, 1, 1);
  }
}

/// A hinge without limits; the axle of a wheel that a universal joint steers, too. What a hinge with limits turns is
/// driven as the robot steers, and rolls on the axle that carries it.
bool rolls_by_itself(const Scene& scene, const SceneShape& shape) {
  using enum model::JointType;
  return std::any_of(scene.joints.begin(), scene.joints.end(), [&](const SceneJoint& joint) {
    if (joint.child != shape.body) return false;
    if (joint.type == kBall) return true;
    const bool has_two = joint.type == kUniversal || joint.type == kRevolute2;
    if (!has_two && !can_turn_over(joint)) return false;
    return std::any_of(joint.axes.begin(), joint.axes.end(), [&](const SceneAxis& axis) {
      return round_about(scene, shape, axis.direction_W).has_value();
    });
  });
}

}  // namespace

void add_wheel_causes(Causes& causes) {
  const DriveTrain& wheels = causes.wheels;
  if (wheels.empty()) return;
  for (const auto* side : {&wheels.left, &wheels.right}) {
    for (const Wheel& wheel : *side) {
      add_geometry(causes, wheel);
      add_friction(causes, wheel);
    }
  }
  add_radii(causes);
  for (const auto* side : {&wheels.left, &wheels.right}) {
    for (const Wheel& wheel : *side) {
      if (wheel.sign > 0) continue;
      Fact about = about_joint(causes.scene, wheel.joint);
      about.name = "reversed";
      about.help = "negate the joint's `axis`";
      causes.add(FactKind::kCauseWheelAxis, std::move(about), wheel.sign, 0, 2, 1);
    }
  }
  if (!wheels.steers()) return;
  for (const std::uint32_t caster : wheels.casters) {
    const SceneShape& shape = causes.scene.shapes[caster];
    const double mu = std::max(shape.surface.mu, shape.surface.mu2);
    if (mu <= kCasterMu || rolls_by_itself(causes.scene, shape)) continue;
    causes.add(FactKind::kCauseCasterFriction, about_shape(causes.scene, caster), mu, kCasterMu,
               mu / kCasterMu, kCasterSevere);
  }
}

}  // namespace rigor::simulate
