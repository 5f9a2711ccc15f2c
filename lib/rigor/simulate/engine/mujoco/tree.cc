// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/engine/mujoco/tree.h>

#include <algorithm>
#include <cstddef>

namespace rigor::simulate {
namespace {

class TreeMaker {
 public:
  explicit TreeMaker(const Scene& scene)
      : scene_(scene), first_(scene.bodies.size(), kWorld), used_(scene.joints.size(), false) {}

  std::vector<TreeNode> make() {
    for (std::uint32_t i = 0; i < scene_.bodies.size(); ++i) {
      if (scene_.bodies[i].kinematic) {
        add({.body = i, .held = TreeNode::Held::kByNothing});
      }
    }
    grow(kWorld);
    for (std::uint32_t i = 0; i < first_.size(); ++i) {
      if (scene_.bodies[i].kinematic) grow(i);
    }
    for (const SceneModel& model : scene_.models) grow_root(model.base);
    for (std::uint32_t i = 0; i < first_.size(); ++i) {
      if (!is_carried(i)) grow_root(i);
    }
    for (std::uint32_t i = 0; i < first_.size(); ++i) grow_root(i);  // loops without a base
    close_loops();
    return std::move(nodes_);
  }

 private:
  void add(const TreeNode& node) {
    if (first_[node.body] == kWorld) first_[node.body] = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back(node);
  }

  bool is_placed(std::uint32_t body) const { return body == kWorld || first_[body] != kWorld; }

  bool is_carried(std::uint32_t body) const {
    return std::any_of(scene_.joints.begin(), scene_.joints.end(), [&](const SceneJoint& joint) {
      return carries(joint) && joint.child == body;
    });
  }

  void grow_root(std::uint32_t body) {
    if (body >= first_.size() || is_placed(body)) return;
    add({.body = body});
    grow(body);
  }

  std::uint32_t node_of(std::uint32_t body) const { return body == kWorld ? kWorld : first_[body]; }

  /// Breadth first, so that a loop is cut far from its base; joints that run from the base on first.
  void grow(std::uint32_t root) {
    std::vector<std::uint32_t> bodies{root};
    for (std::size_t next = 0; next < bodies.size(); ++next) {
      for (const bool reversed : {false, true}) {
        for (std::uint32_t j = 0; j < scene_.joints.size(); ++j) {
          const SceneJoint& joint = scene_.joints[j];
          const std::uint32_t from = reversed ? joint.child : joint.parent;
          const std::uint32_t to = reversed ? joint.parent : joint.child;
          if (!carries(joint) || from != bodies[next] || is_placed(to)) continue;
          add({.body = to,
               .parent = node_of(from),
               .joint = j,
               .held = TreeNode::Held::kByJoint,
               .reversed = reversed});
          used_[j] = true;
          bodies.push_back(to);
        }
      }
    }
  }

  bool moves(std::uint32_t body) const { return body != kWorld && !scene_.bodies[body].kinematic; }

  void close_loops() {
    std::vector<double> parts(first_.size(), 1);
    for (std::uint32_t j = 0; j < scene_.joints.size(); ++j) {
      const SceneJoint& joint = scene_.joints[j];
      if (used_[j] || !carries(joint) || joint.parent == joint.child) continue;
      const bool reversed = !moves(joint.child);
      const std::uint32_t body = reversed ? joint.parent : joint.child;
      if (!moves(body)) continue;
      add({.body = body,
           .parent = node_of(reversed ? joint.child : joint.parent),
           .joint = j,
           .held = TreeNode::Held::kByJoint,
           .reversed = reversed,
           .half = true});
      ++parts[body];
    }
    for (TreeNode& node : nodes_) node.share = 1 / parts[node.body];
  }

  const Scene& scene_;
  std::vector<TreeNode> nodes_;
  std::vector<std::uint32_t> first_;  ///< body by body, its node
  std::vector<bool> used_;            ///< joint by joint, as an edge
};

}  // namespace

bool carries(const SceneJoint& joint) {
  return joint.type != model::JointType::kGearbox && joint.type != model::JointType::kFixed;
}

std::vector<TreeNode> scene_tree(const Scene& scene) { return TreeMaker(scene).make(); }

}  // namespace rigor::simulate
