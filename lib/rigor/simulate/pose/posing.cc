// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/pose/posing.h>

#include <algorithm>
#include <utility>

#include <rigor/simulate/joint_load.h>

namespace rigor::simulate {
namespace {

bool is_posed(const SceneJoint& joint) {
  using enum model::JointType;
  return joint.axes.size() == 1 &&
         (joint.type == kRevolute || joint.type == kContinuous || joint.type == kPrismatic);
}

}  // namespace

Posing::Posing(const Scene& scene)
    : scene_(scene), bodies_(scene.bodies), joints_(scene.joints), carried_(scene.joints.size()) {
  const CarriedBodies carried(scene);
  std::vector<bool> hangs(scene.bodies.size());
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const SceneJoint& joint = joints_[j];
    start_.push_back(is_posed(joint) ? joint.axes[0].start : 0);
    if (joint.child >= hangs.size() || hangs[joint.child]) {
      tree_ = false;
      continue;
    }
    hangs[joint.child] = true;
    carried_[j] = carried.by(joint.child);
  }
}

const Scene& Posing::at(std::vector<double> positions) {
  follow(positions);
  scene_.bodies = bodies_;
  scene_.joints = joints_;
  for (std::uint32_t j = 0; j < joints_.size(); ++j) {
    if (is_posed(joints_[j]) && positions[j] != start_[j]) move(j, positions[j] - start_[j]);
  }
  return scene_;
}

void Posing::follow(std::vector<double>& positions) const {
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    if (joints_[j].mimics.empty()) continue;
    const SceneMimic& mimic = joints_[j].mimics.front();
    if (mimic.joint >= positions.size()) continue;
    const double moved = positions[mimic.joint] - start_[mimic.joint];
    positions[j] = start_[j] + mimic.multiplier * moved;
  }
}

/// All that the joint carries, as one rigid body: in any order of the joints the same comes of it.
void Posing::move(std::uint32_t joint, double by) {
  SceneAxis& axis = scene_.joints[joint].axes[0];
  const Vector3 anchor = scene_.joints[joint].anchor_W;
  const bool slides = scene_.joints[joint].type == model::JointType::kPrismatic;
  const Quaternion turn = slides ? Quaternion{} : model::from_axis_angle(axis.direction_W, by);
  const Vector3 shift = slides ? by * axis.direction_W : anchor - rotate(turn, anchor);
  const Pose X_move{shift, turn};
  axis.start += by;
  const auto& carried = carried_[joint];
  const auto carries = [&](std::uint32_t body) {
    return std::find(carried.begin(), carried.end(), body) != carried.end();
  };
  for (const std::uint32_t body : carried) {
    scene_.bodies[body].X_WB = compose(X_move, scene_.bodies[body].X_WB);
  }
  for (std::uint32_t j = 0; j < scene_.joints.size(); ++j) {
    SceneJoint& other = scene_.joints[j];
    if (j == joint || !carries(other.parent)) continue;
    other.anchor_W = transform(X_move, other.anchor_W);
    for (SceneAxis& each : other.axes) each.direction_W = rotate(turn, each.direction_W);
  }
}

}  // namespace rigor::simulate
