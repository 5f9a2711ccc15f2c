// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/joint_load.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <rigor/simulate/metric/parts.h>
#include <rigor/simulate/reach.h>
#include <rigor/simulate/wheels.h>

namespace rigor::simulate {
namespace {

/// Of the scene's size: feet are not drawn to the same height.
constexpr double kFootRise = 0.01;

/// kg·m² (of a slider kg): how a body resists the axis when everything else gives way.
double own_inertia(const Scene& scene, const SceneJoint& joint, std::uint32_t b) {
  if (b >= scene.bodies.size()) return kInfinity;
  const SceneBody& body = scene.bodies[b];
  if (joint.type == model::JointType::kPrismatic) return body.mass.mass;
  const Vector3 axis = rotate(conjugate(body.X_WB.rotation), joint.axes[0].direction_W);
  const Vector3 anchor = transform(inverse(body.X_WB), joint.anchor_W);
  return mass::moment_about(axis, mass::about(anchor, body.mass));
}

}  // namespace

CarriedBodies::CarriedBodies(const Scene& scene) : scene_(scene), joints_(scene.bodies.size()) {
  for (std::uint32_t j = 0; j < scene.joints.size(); ++j) {
    const SceneJoint& joint = scene.joints[j];
    if (joint.parent >= joints_.size() || joint.child >= joints_.size()) continue;
    joints_[joint.parent].push_back(j);
  }
}

std::vector<std::uint32_t> CarriedBodies::by(std::uint32_t body) const {
  std::vector<std::uint32_t> all{body};
  std::vector<bool> seen(joints_.size());
  seen[body] = true;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const std::uint32_t j : joints_[all[i]]) {
      const std::uint32_t child = scene_.joints[j].child;
      if (seen[child]) continue;
      seen[child] = true;
      all.push_back(child);
    }
  }
  return all;
}

bool can_be_commanded(const SceneJoint& joint) {
  const bool kind = joint.type == model::JointType::kRevolute ||
                    joint.type == model::JointType::kContinuous ||
                    joint.type == model::JointType::kPrismatic;
  return kind && joint.axes.size() == 1 && joint.mimics.empty();
}

double effective_inertia(const Scene& scene, const SceneJoint& joint) {
  return 1 /
         (1 / own_inertia(scene, joint, joint.child) + 1 / own_inertia(scene, joint, joint.parent));
}

JointLoads::JointLoads(const Scene& scene) : scene_(scene), carried_(scene) {
  in_W_.reserve(scene.bodies.size());
  for (const SceneBody& body : scene.bodies) {
    in_W_.push_back(mass::transformed(body.X_WB, body.mass));
  }
  find_feet();
}

void JointLoads::find_feet() {
  feet_.resize(scene_.bodies.size());
  const double slack = std::max(kTouchGap, kFootRise * scene_.size);
  for (std::uint32_t m = 0; m < scene_.models.size(); ++m) {
    if (!stands_free(scene_, m)) continue;
    const double ground = lowest_of_model(scene_, m) + slack;
    std::vector<Vector3> sum(feet_.size());
    std::vector<double> points(feet_.size());
    for (const SceneShape& shape : scene_.shapes) {
      if (shape.body >= feet_.size() || scene_.bodies[shape.body].model != m) continue;
      for (const Vector3& point : low_points(scene_, shape, ground)) {
        sum[shape.body] = sum[shape.body] + point;
        points[shape.body] += 1;
      }
    }
    Vector3 weight;
    double touching = 0;
    for (std::size_t b = 0; b < feet_.size(); ++b) {
      const SceneBody& body = scene_.bodies[b];
      if (body.model == m && body.gravity) weight = weight + body.mass.mass * scene_.gravity;
      touching += points[b] > 0 ? 1 : 0;
    }
    for (std::size_t b = 0; b < feet_.size(); ++b) {
      if (points[b] > 0) feet_[b] = {true, (1 / points[b]) * sum[b], (-1 / touching) * weight};
    }
  }
}

double JointLoads::standing(const SceneJoint& joint) const {
  const Vector3& axis = joint.axes[0].direction_W;
  const bool slides = joint.type == model::JointType::kPrismatic;
  double effort = gravity_effort(joint, 0);
  for (const std::uint32_t b : carried_.by(joint.child)) {
    const Foot& foot = feet_[b];
    if (!foot.stands) continue;
    effort +=
        dot(axis, slides ? foot.force_W : cross(foot.middle_W - joint.anchor_W, foot.force_W));
  }
  return std::abs(effort);
}

double JointLoads::inertia(const SceneJoint& joint) const {
  const bool slides = joint.type == model::JointType::kPrismatic;
  double sum = 0;
  for (const std::uint32_t b : carried_.by(joint.child)) {
    sum += slides ? in_W_[b].mass
                  : mass::moment_about(joint.axes[0].direction_W,
                                       mass::about(joint.anchor_W, in_W_[b]));
  }
  return sum;
}

/// What gravity does along the axis when the joint is so far from its start.
double JointLoads::gravity_effort(const SceneJoint& joint, double moved) const {
  const Vector3& axis = joint.axes[0].direction_W;
  const bool slides = joint.type == model::JointType::kPrismatic;
  const Quaternion turn = model::from_axis_angle(axis, moved);
  double sum = 0;
  for (const std::uint32_t b : carried_.by(joint.child)) {
    if (!scene_.bodies[b].gravity) continue;
    const Vector3 weight = in_W_[b].mass * scene_.gravity;
    const Vector3 arm = in_W_[b].com - joint.anchor_W;
    sum += dot(axis, slides ? weight : cross(rotate(turn, arm), weight));
  }
  return sum;
}

double JointLoads::weight(const SceneJoint& joint) const {
  return std::abs(gravity_effort(joint, 0));
}

double JointLoads::standing_inertia(const SceneJoint& joint) const {
  const Vector3& axis = joint.axes[0].direction_W;
  const bool slides = joint.type == model::JointType::kPrismatic;
  const double g = length(scene_.gravity);
  double sum = inertia(joint);
  for (const std::uint32_t b : carried_.by(joint.child)) {
    const Foot& foot = feet_[b];
    if (!foot.stands || !(g > 0)) continue;
    const Vector3 lever = cross(axis, foot.middle_W - joint.anchor_W);
    sum += length(foot.force_W) / g * (slides ? 1 : dot(lever, lever));
  }
  return sum;
}

double JointLoads::sweep_effort(const SceneJoint& joint, const SweepMotion& motion) const {
  const SceneAxis& axis = joint.axes[0];
  const auto load = [&](double position) { return gravity_effort(joint, position - axis.start); };
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
  const double push = inertia(joint) * motion.acceleration;
  most = std::max({most, std::abs(load(motion.least) - push), std::abs(load(motion.most) + push),
                   std::abs(load(axis.start)) + push});
  return most + axis.friction;
}

}  // namespace rigor::simulate
