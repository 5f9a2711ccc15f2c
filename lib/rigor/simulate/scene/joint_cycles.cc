// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/scene/joint_cycles.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include <rigor/text/disjoint_sets.h>

namespace rigor::simulate {
namespace {

/// A spanning forest of the bodies and the world. Each joint that is not in it closes a loop with the way between its
/// ends.
class JointForest {
 public:
  explicit JointForest(const Scene& scene)
      : scene_(scene),
        world_(static_cast<std::uint32_t>(scene.bodies.size())),
        joints_of_(world_ + std::size_t{1}),
        above_(world_ + std::size_t{1}, kWorld),
        depth_(world_ + std::size_t{1}, kUnseen) {
    for (std::uint32_t j = 0; j < scene.joints.size(); ++j) {
      for (const std::uint32_t end : ends(j)) joints_of_[end].push_back(j);
    }
    grow(world_);
    for (std::uint32_t body = 0; body < world_; ++body) grow(body);
  }

  bool holds(std::uint32_t joint) const {
    const auto [a, b] = ends(joint);
    return above_[a] == joint || above_[b] == joint;
  }

  /// The joints between the ends of one that is not in the forest.
  std::vector<std::uint32_t> way(std::uint32_t joint) const {
    std::vector<std::uint32_t> joints;
    auto [a, b] = ends(joint);
    while (a != b) {
      std::uint32_t& deeper = depth_[a] < depth_[b] ? b : a;
      joints.push_back(above_[deeper]);
      deeper = other_end(above_[deeper], deeper);
    }
    return joints;
  }

 private:
  static constexpr std::uint32_t kUnseen = kWorld;

  std::array<std::uint32_t, 2> ends(std::uint32_t joint) const {
    const SceneJoint& one = scene_.joints[joint];
    return {std::min(one.parent, world_), std::min(one.child, world_)};
  }

  std::uint32_t other_end(std::uint32_t joint, std::uint32_t body) const {
    const auto [a, b] = ends(joint);
    return a == body ? b : a;
  }

  void grow(std::uint32_t root) {
    if (depth_[root] != kUnseen) return;
    depth_[root] = 0;
    std::vector<std::uint32_t> open{root};
    for (std::size_t i = 0; i < open.size(); ++i) {
      for (const std::uint32_t joint : joints_of_[open[i]]) {
        const std::uint32_t next = other_end(joint, open[i]);
        if (depth_[next] != kUnseen) continue;
        depth_[next] = depth_[open[i]] + 1;
        above_[next] = joint;
        open.push_back(next);
      }
    }
  }

  const Scene& scene_;
  std::uint32_t world_;
  std::vector<std::vector<std::uint32_t>> joints_of_;
  std::vector<std::uint32_t> above_;  // of a body the joint toward its root; kWorld of a root
  std::vector<std::uint32_t> depth_;
};

}  // namespace

std::vector<std::uint32_t> joint_cycles(const Scene& scene) {
  const JointForest forest(scene);
  DisjointSets sets(scene.joints.size());
  std::vector<bool> is_in_one(scene.joints.size());
  for (std::uint32_t j = 0; j < scene.joints.size(); ++j) {
    if (forest.holds(j)) continue;
    is_in_one[j] = true;
    for (const std::uint32_t other : forest.way(j)) {
      is_in_one[other] = true;
      sets.join(j, other);
    }
  }
  std::vector<std::uint32_t> cycles(scene.joints.size(), kWorld);
  for (std::uint32_t j = 0; j < cycles.size(); ++j) {
    if (is_in_one[j]) cycles[j] = static_cast<std::uint32_t>(sets.find(j));
  }
  return cycles;
}

}  // namespace rigor::simulate
