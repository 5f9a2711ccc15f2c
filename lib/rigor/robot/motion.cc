// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How a robot hangs together, and where its bodies are at given joint
// positions. Chains are walked with lists of our own, since a file decides how
// long they are.

#include <cmath>
#include <string_view>
#include <unordered_map>
#include <utility>

#include <rigor/robot/robot.h>

namespace rigor::robot {
namespace {

using model::Pose;

/// Appends all that hangs on `from`, which is in the order already, or about to
/// be put there.
void append_tree(Robot& robot, std::uint32_t from,
                 const std::vector<std::vector<std::uint32_t>>& carried, std::vector<bool>& seen) {
  std::size_t next = robot.order.size();
  robot.order.push_back(from);
  seen[from] = true;
  for (; next < robot.order.size(); ++next) {
    for (const std::uint32_t child : carried[robot.order[next]]) {
      if (seen[child]) continue;
      seen[child] = true;
      robot.order.push_back(child);
    }
  }
}

double position_at(const Positions& positions, std::size_t joint, std::size_t axis) {
  return joint < positions.size() && axis < positions[joint].size() ? positions[joint][axis] : 0;
}

}  // namespace

void connect(Robot& robot) {
  for (Body& body : robot.bodies) body.carrier = kNoIndex;
  for (std::uint32_t i = 0; i < robot.joints.size(); ++i) {
    Body& child = robot.bodies[robot.joints[i].child];
    robot.joints[i].closes_loop = child.carrier != kNoIndex;
    if (child.carrier == kNoIndex) child.carrier = i;
  }
  std::vector<std::vector<std::uint32_t>> carried(robot.bodies.size());
  for (std::uint32_t i = 0; i < robot.bodies.size(); ++i) {
    const std::uint32_t carrier = robot.bodies[i].carrier;
    if (carrier != kNoIndex) carried[robot.joints[carrier].parent].push_back(i);
  }
  std::vector<bool> seen(robot.bodies.size());
  robot.order.clear();
  for (std::uint32_t i = 0; i < robot.bodies.size(); ++i) {
    if (robot.bodies[i].carrier == kNoIndex) append_tree(robot, i, carried, seen);
  }
  for (std::uint32_t i = 0; i < robot.bodies.size(); ++i) {  // circles of joints
    if (seen[i]) continue;
    robot.joints[robot.bodies[i].carrier].closes_loop = true;
    robot.bodies[i].carrier = kNoIndex;
    append_tree(robot, i, carried, seen);
  }
  const std::vector<Pose> X_MB = body_poses(robot, {});
  for (std::size_t i = 0; i < X_MB.size(); ++i) robot.bodies[i].X_MB = X_MB[i];
  for (Joint& joint : robot.joints) {
    joint.X_CJ = joint.closes_loop
                     ? compose(inverse(X_MB[joint.child]), compose(X_MB[joint.parent], joint.X_PJ))
                     : Pose{};
  }
}

Pose motion(const Axis& axis, double q) {
  Pose X;
  if (length(axis.direction) == 0) return X;
  if (axis.motion == Axis::Motion::kSlide) return {q * axis.direction, {}};
  X.rotation = model::from_axis_angle(axis.direction, q);
  if (axis.motion == Axis::Motion::kScrew) X.translation = axis.slide * q * axis.direction;
  return X;
}

std::vector<Pose> body_poses(const Robot& robot, const Positions& positions) {
  std::vector<Pose> X_MB(robot.bodies.size());
  for (const std::uint32_t i : robot.order) {
    const Body& body = robot.bodies[i];
    if (body.carrier == kNoIndex) {
      X_MB[i] = body.X_MB;
      continue;
    }
    const Joint& joint = robot.joints[body.carrier];
    Pose X = compose(X_MB[joint.parent], joint.X_PJ);
    for (std::size_t k = 0; k < joint.axes.size(); ++k) {
      const double q = position_at(positions, body.carrier, k);
      if (q != 0) X = compose(X, motion(joint.axes[k], q));
    }
    X.rotation = normalized(X.rotation);  // long chains would drift
    X_MB[i] = X;
  }
  return X_MB;
}

Positions followed(const Robot& robot, Positions positions) {
  struct Place {
    std::size_t joint, axis;
  };
  std::unordered_map<std::string_view, std::size_t> by_name;
  std::vector<std::vector<bool>> settled(robot.joints.size());
  positions.resize(robot.joints.size());
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    by_name.try_emplace(robot.joints[i].name, i);
    positions[i].resize(robot.joints[i].axes.size());
    settled[i].resize(robot.joints[i].axes.size());
  }
  const auto leader = [&](const Place& at) -> std::optional<Place> {
    const auto& follow = robot.joints[at.joint].axes[at.axis].follow;
    if (!follow) return std::nullopt;
    const auto found = by_name.find(follow->joint);
    if (found == by_name.end()) return std::nullopt;
    if (follow->axis >= robot.joints[found->second].axes.size()) return std::nullopt;
    return Place{found->second, follow->axis};
  };
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    for (std::size_t k = 0; k < robot.joints[i].axes.size(); ++k) {
      std::vector<Place> chain;  // followers on the way to one that is settled;
                                 // a circle ends too
      for (std::optional<Place> at = Place{i, k}; at && !settled[at->joint][at->axis];
           at = leader(*at)) {
        settled[at->joint][at->axis] = true;
        chain.push_back(*at);
      }
      for (; !chain.empty(); chain.pop_back()) {
        const Place at = chain.back();
        const auto lead = leader(at);
        if (!lead) continue;
        const Mimic& follow = *robot.joints[at.joint].axes[at.axis].follow;
        positions[at.joint][at.axis] =
            follow.multiplier * positions[lead->joint][lead->axis] + follow.offset;
      }
    }
  }
  return positions;
}

Moments moments(const Robot& robot, const std::vector<Pose>& X_RB) {
  Moments sum;
  for (std::size_t i = 0; i < robot.bodies.size() && i < X_RB.size(); ++i) {
    if (robot.bodies[i].mass == mass::MassProperties{}) continue;
    const mass::MassProperties body = mass::transformed(X_RB[i], robot.bodies[i].mass);
    sum.mass += body.mass;
    sum.first = sum.first + body.mass * body.com;
    sum.second = sum.second + mass::about_origin(body);
  }
  return sum;
}

}  // namespace rigor::robot
