// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The tree that the joints of a URDF robot make of its links, as far as it is one.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/model/frames.h>
#include <rigor/model/model.h>

namespace rigor::rules {

struct Tree {
  /// Per link of the robot, in its order: the joints whose child it is.
  std::vector<std::vector<model::Id<model::Joint>>> parents;
  /// Per link, whether it lies on a loop, or between two.
  std::vector<bool> on_loop;
  /// Whether every joint's ends are links; else links only look as if they hung on nothing.
  bool complete = true;
};

/// Per link, other links by their place in the robot.
using Neighbors = std::vector<std::vector<std::size_t>>;

/// Removes the links without a predecessor, then those that have none left, and so on.
inline void peel(const Neighbors& before, const Neighbors& after, std::vector<bool>& gone) {
  std::vector<std::size_t> left(gone.size(), 0);
  std::vector<std::size_t> ready;
  for (std::size_t i = 0; i < gone.size(); ++i) {
    if (gone[i]) continue;
    for (const std::size_t other : before[i]) left[i] += gone[other] ? 0 : 1;
    if (left[i] == 0) ready.push_back(i);
  }
  while (!ready.empty()) {
    const std::size_t link = ready.back();
    ready.pop_back();
    gone[link] = true;
    for (const std::size_t other : after[link]) {
      if (!gone[other] && --left[other] == 0) ready.push_back(other);
    }
  }
}

inline Tree tree_of(const model::Root& root, const model::Frames& frames,
                    const model::Model& robot) {
  const std::size_t count = robot.links.size();
  std::vector<std::size_t> place(root.links.size(), count);
  for (std::size_t i = 0; i < count; ++i) place[robot.links[i].value] = i;

  Tree tree;
  tree.parents.resize(count);
  Neighbors up(count), down(count);
  for (const auto id : robot.joints) {
    const auto& ends = frames.ends(id);
    const std::size_t parent = ends.parent ? place[ends.parent.value] : count;
    const std::size_t child = ends.child ? place[ends.child.value] : count;
    if (parent == count || child == count) {
      tree.complete = false;
      continue;
    }
    tree.parents[child].push_back(id);
    up[child].push_back(parent);
    down[parent].push_back(child);
  }
  std::vector<bool> gone(count, false);
  peel(up, down, gone);
  peel(down, up, gone);
  gone.flip();
  tree.on_loop = std::move(gone);
  return tree;
}

/// Of a joint whose child another joint has, too: the link that no joint carries, and whose name this joint has in its
/// own, as left_wheel_joint has; but for _link. Null when there is none.
inline const model::Link* misnamed_child(const model::Joint& joint, const Tree& tree,
                                         const model::Model& robot, const model::Root& root) {
  for (std::size_t i = 0; i < tree.parents.size(); ++i) {
    const model::Link& link = root[robot.links[i]];
    std::string_view name = link.name.value;
    if (!tree.parents[i].empty() || name == joint.parent.value) continue;
    if (name.ends_with("_link")) name.remove_suffix(5);
    if (name.size() > 2 && joint.name.value.find(name) != std::string::npos) return &link;
  }
  return nullptr;
}

}  // namespace rigor::rules
