// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/robot_laws.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace rigor::author {

using model::Pose;

std::vector<bool> subtree_of(const robot::Robot& robot, std::uint32_t body) {
  std::vector<bool> in(robot.bodies.size());
  for (const std::uint32_t i : robot.order) {
    const std::uint32_t carrier = robot.bodies[i].carrier;
    in[i] = i == body || (carrier != robot::kNoIndex && in[robot.joints[carrier].parent]);
  }
  return in;
}

namespace {

/// A gearbox goes with its wheels; a `<mimic>` of a joint that goes is refused before.
void drop_gears_without_leader(robot::Robot& robot) {
  std::set<std::string> names;
  for (const robot::Joint& joint : robot.joints) names.insert(joint.name);
  for (robot::Joint& joint : robot.joints) {
    for (robot::Axis& axis : joint.axes) {
      if (axis.follow && !names.contains(axis.follow->joint)) axis.follow.reset();
    }
  }
}

}  // namespace

robot::Robot restricted(const robot::Robot& robot, const std::vector<bool>& kept) {
  robot::Robot result = robot;
  result.bodies.clear();
  result.joints.clear();
  result.frames.clear();
  std::vector<std::uint32_t> index(robot.bodies.size(), robot::kNoIndex);
  const auto is_joined = [&](std::uint32_t body) {
    return std::any_of(robot.joints.begin(), robot.joints.end(), [&](const robot::Joint& joint) {
      return kept[joint.parent] && kept[joint.child] &&
             (joint.parent == body || joint.child == body);
    });
  };
  for (std::uint32_t i = 0; i < robot.bodies.size(); ++i) {
    if (!kept[i]) continue;
    // The world is a body only where something hangs on it.
    if (robot.bodies[i].name == robot::kWorldBody && robot.bodies[i].span.nowhere() &&
        !is_joined(i))
      continue;
    index[i] = static_cast<std::uint32_t>(result.bodies.size());
    result.bodies.push_back(robot.bodies[i]);
  }
  for (const robot::Joint& joint : robot.joints) {
    if (!kept[joint.parent] || !kept[joint.child]) continue;
    result.joints.push_back(joint);
    result.joints.back().parent = index[joint.parent];
    result.joints.back().child = index[joint.child];
  }
  drop_gears_without_leader(result);
  for (const robot::Frame& frame : robot.frames) {
    if (frame.body == robot::kNoIndex || index[frame.body] == robot::kNoIndex) continue;
    result.frames.push_back(frame);
    result.frames.back().body = index[frame.body];
  }
  robot::connect(result);
  return result;
}

void describe_in(robot::Robot& robot, std::uint32_t body, const Pose& X_BN) {
  const Pose X_NB = inverse(X_BN);
  robot::Body& changed = robot.bodies[body];
  changed.mass = mass::transformed(X_NB, changed.mass);
  for (auto* parts : {&changed.collisions, &changed.visuals}) {
    for (robot::Part& part : *parts) part.X_BS = compose(X_NB, part.X_BS);
  }
  changed.X_MB = compose(changed.X_MB, X_BN);
  for (robot::Joint& joint : robot.joints) {
    if (joint.parent == body) joint.X_PJ = compose(X_NB, joint.X_PJ);
  }
  for (robot::Frame& frame : robot.frames) {
    if (frame.body == body) frame.X_BF = compose(X_NB, frame.X_BF);
  }
}

std::vector<std::uint32_t> path_to_root(const robot::Robot& robot, std::uint32_t body) {
  std::vector<std::uint32_t> path;
  for (std::uint32_t i = body; robot.bodies[i].carrier != robot::kNoIndex;) {
    path.push_back(robot.bodies[i].carrier);
    i = robot.joints[path.back()].parent;
  }
  return path;
}

}  // namespace rigor::author
