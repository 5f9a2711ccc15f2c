// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/lumping.h>

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace rigor::robot {
namespace {

using model::JointType;
using model::Pose;

class BodyHolder {
 public:
  explicit BodyHolder(const Robot& robot)
      : from_(robot),
        group_(robot.bodies.size()),
        X_GB_(robot.bodies.size()),
        holder_(robot.bodies.size()) {
    for (const std::uint32_t i : robot.order) {
      group_[i] = holder_[i] = i;
      const std::uint32_t carrier = robot.bodies[i].carrier;
      if (carrier == kNoIndex || robot.joints[carrier].type != JointType::kFixed) continue;
      const std::uint32_t parent = robot.joints[carrier].parent;
      group_[i] = group_[parent];
      X_GB_[i] = compose(X_GB_[parent], robot.joints[carrier].X_PJ);
    }
  }

  Robot hold(const std::map<std::string, std::string>& held_by) {
    choose_holders(held_by);
    Robot to = from_;
    to.bodies.clear();
    to.joints.clear();
    add_bodies(to);
    const std::vector<Frame> joints = add_joints(to);
    for (Frame& frame : to.frames) {
      if (frame.body == kNoIndex) continue;
      frame.X_BF = in_holder(frame.body, frame.X_BF);
      frame.body = new_index(frame.body);
    }
    for (std::uint32_t i = 0; i < holder_.size(); ++i) {
      const Body& body = from_.bodies[i];
      if (is_held(i)) to.frames.push_back({body.name, new_index(i), in_holder(i, {}), body.span});
    }
    to.frames.insert(to.frames.end(), joints.begin(), joints.end());
    connect(to);
    return to;
  }

 private:
  bool is_held(std::uint32_t i) const { return holder_[i] != i; }
  std::uint32_t new_index(std::uint32_t i) const { return index_[holder_[i]]; }

  /// What stands there in the body, in the one that holds it.
  Pose in_holder(std::uint32_t i, const Pose& X) const {
    if (!is_held(i)) return X;
    return compose(inverse(X_GB_[holder_[i]]), compose(X_GB_[i], X));
  }

  void choose_holders(const std::map<std::string, std::string>& held_by) {
    std::unordered_map<std::string_view, std::uint32_t> named;
    for (std::uint32_t i = 0; i < holder_.size(); ++i) named.try_emplace(from_.bodies[i].name, i);
    for (const auto& [body, holder] : held_by) {
      const auto held = named.find(body), by = named.find(holder);
      if (held == named.end() || by == named.end() || held_by.contains(holder)) continue;
      if (group_[held->second] == group_[by->second]) holder_[held->second] = by->second;
    }
  }

  void add_bodies(Robot& to) {
    index_.assign(holder_.size(), kNoIndex);
    for (std::uint32_t i = 0; i < holder_.size(); ++i) {
      if (is_held(i)) continue;
      index_[i] = static_cast<std::uint32_t>(to.bodies.size());
      to.bodies.push_back(from_.bodies[i]);
      to.bodies.back().mass = {};
      to.bodies.back().collisions.clear();
      to.bodies.back().visuals.clear();
    }
    for (const std::uint32_t i : downwards()) {
      const Body& body = from_.bodies[i];
      Body& holder = to.bodies[new_index(i)];
      const Pose X_HB = in_holder(i, {});
      const bool alone = holder.mass == mass::MassProperties{} && !is_held(i);
      holder.mass = alone ? body.mass : mass::add(holder.mass, mass::transformed(X_HB, body.mass));
      add_parts(body.collisions, i, holder.collisions);
      add_parts(body.visuals, i, holder.visuals);
    }
  }

  void add_parts(const std::vector<Part>& parts, std::uint32_t body, std::vector<Part>& to) const {
    for (Part part : parts) {
      part.X_BS = in_holder(body, part.X_BS);
      to.push_back(std::move(part));
    }
  }

  /// Each before all that hangs on it, in the order of the file: so parts without a name come to stand.
  std::vector<std::uint32_t> downwards() const {
    std::vector<std::vector<std::uint32_t>> carried(holder_.size());
    std::vector<std::uint32_t> stack, order;
    for (std::uint32_t i = 0; i < from_.joints.size(); ++i) {
      const Joint& joint = from_.joints[i];
      if (from_.bodies[joint.child].carrier == i) carried[joint.parent].push_back(joint.child);
    }
    for (std::uint32_t i = 0; i < holder_.size(); ++i) {
      if (from_.bodies[i].carrier == kNoIndex) stack.push_back(i);
    }
    std::reverse(stack.begin(), stack.end());
    while (!stack.empty()) {
      const std::uint32_t i = stack.back();
      stack.pop_back();
      order.push_back(i);
      stack.insert(stack.end(), carried[i].rbegin(), carried[i].rend());
    }
    return order;
  }

  /// What carried a body that is held is no joint any more, nor what lies inside a holder: the frames
  /// where these joints were.
  std::vector<Frame> add_joints(Robot& to) const {
    std::vector<Frame> gone;
    for (std::uint32_t i = 0; i < from_.joints.size(); ++i) {
      Joint joint = from_.joints[i];
      const bool fixed = joint.type == JointType::kFixed;
      const bool carries_held = is_held(joint.child) && from_.bodies[joint.child].carrier == i;
      if (fixed && (carries_held || holder_[joint.parent] == holder_[joint.child])) {
        gone.push_back({.name = joint.name,
                        .body = new_index(joint.child),
                        .X_BF = in_holder(joint.child, {}),
                        .span = joint.span,
                        .of_joint = true});
        continue;
      }
      joint.X_PJ = in_holder(joint.parent, joint.X_PJ);
      joint.parent = new_index(joint.parent);
      joint.child = new_index(joint.child);
      to.joints.push_back(std::move(joint));
    }
    return gone;
  }

  const Robot& from_;
  std::vector<std::uint32_t> group_;   ///< the first of the bodies that are fixed to each other
  std::vector<Pose> X_GB_;             ///< in that one
  std::vector<std::uint32_t> holder_;  ///< itself, unless it is held
  std::vector<std::uint32_t> index_;   ///< in the result
};

}  // namespace

Robot with_embedded(const Robot& robot, const std::map<std::string, std::string>& held_by) {
  return BodyHolder(robot).hold(held_by);
}

Robot in_world(Robot robot) {
  const Pose X_WM = robot.X_WM.value_or(Pose{});
  robot.X_WM = Pose{};
  auto world = std::find_if(robot.bodies.begin(), robot.bodies.end(),
                            [](const Body& body) { return body.name == kWorldBody; });
  if (world == robot.bodies.end()) world = robot.bodies.insert(world, {.name = kWorldBody});
  const auto at = static_cast<std::uint32_t>(world - robot.bodies.begin());
  for (Joint& joint : robot.joints) {
    if (joint.parent == at) joint.X_PJ = compose(X_WM, joint.X_PJ);
  }
  for (Frame& frame : robot.frames) {
    if (frame.body == at) frame.X_BF = compose(X_WM, frame.X_BF);
  }
  for (std::uint32_t i = 0; i < robot.bodies.size(); ++i) {
    if (i == at || robot.bodies[i].carrier != kNoIndex) continue;
    robot.joints.push_back({.type = JointType::kFixed,
                            .parent = at,
                            .child = i,
                            .X_PJ = compose(X_WM, robot.bodies[i].X_MB)});
  }
  connect(robot);
  return robot;
}

void remove(Robot& robot, const PartNames& bodies, const PartNames& joints) {
  std::vector<std::uint32_t> moved(robot.bodies.size(), kNoIndex);
  std::vector<Body> left;
  for (std::uint32_t i = 0; i < robot.bodies.size(); ++i) {
    if (bodies.contains(robot.bodies[i].name)) continue;
    moved[i] = static_cast<std::uint32_t>(left.size());
    left.push_back(std::move(robot.bodies[i]));
  }
  robot.bodies = std::move(left);
  std::erase_if(robot.joints, [&](const Joint& joint) {
    return joints.contains(joint.name) || moved[joint.parent] == kNoIndex ||
           moved[joint.child] == kNoIndex;
  });
  for (Joint& joint : robot.joints) {
    joint.parent = moved[joint.parent];
    joint.child = moved[joint.child];
  }
  std::erase_if(robot.frames, [&](const Frame& frame) {
    return frame.body != kNoIndex && moved[frame.body] == kNoIndex;
  });
  for (Frame& frame : robot.frames) {
    if (frame.body != kNoIndex) frame.body = moved[frame.body];
  }
  connect(robot);
}

}  // namespace rigor::robot
