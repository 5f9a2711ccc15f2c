// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf_tree.h>

#include <numeric>

namespace rigor::convert {
namespace {

using model::Id;

/// Which links hang together (union-find with path halving).
class LinkGroups {
 public:
  explicit LinkGroups(std::size_t links) : up_(links) { std::iota(up_.begin(), up_.end(), 0U); }

  bool together(Id<model::Link> a, Id<model::Link> b) { return top(a.value) == top(b.value); }
  void join(Id<model::Link> a, Id<model::Link> b) { up_[top(b.value)] = top(a.value); }

 private:
  std::uint32_t top(std::uint32_t at) {
    while (up_[at] != at) at = up_[at] = up_[up_[at]];
    return at;
  }

  std::vector<std::uint32_t> up_;
};

class UrdfTreeBuilder {
 public:
  UrdfTreeBuilder(const model::Root& root, const model::Frames& frames)
      : root_(root), frames_(frames), groups_(root.links.size()) {}

  UrdfTree build(Id<model::Model> top) && {
    find_parts(top);
    tree_.carriers.resize(root_.links.size());
    for (std::uint32_t i = 0; i < root_.joints.size(); ++i) {
      if (is_inside(root_.joints[i].model)) add({i});
    }
    for (const Id<model::Link> link : tree_.links) {
      if (!tree_.carriers[link.value]) tree_.roots.push_back(link);
    }
    return std::move(tree_);
  }

 private:
  bool is_inside(Id<model::Model> id) const { return id && inside_[id.value]; }

  /// A nested model comes after the one that it is in.
  void find_parts(Id<model::Model> top) {
    inside_.resize(root_.models.size());
    for (std::uint32_t i = top.value; i < root_.models.size(); ++i) {
      inside_[i] = i == top.value || is_inside(root_.models[i].parent);
      if (inside_[i]) tree_.models.push_back({i});
    }
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
      if (is_inside(root_.links[i].model)) tree_.links.push_back({i});
    }
    for (std::uint32_t i = 0; i < root_.frames.size(); ++i) {
      if (is_inside(root_.frames[i].model)) tree_.frames.push_back({i});
    }
  }

  bool is_part(Id<model::Link> link) const { return link && is_inside(root_[link].model); }

  void add(Id<model::Joint> joint) {
    const auto& [parent, child, parent_is_world] = frames_.ends(joint);
    const auto leave_out = [&](UrdfTree::Flaw flaw, Id<model::Joint> carrier = {}) {
      tree_.left_out.push_back({joint, flaw, carrier});
    };
    if (!is_part(child) || !(parent_is_world || is_part(parent)) || parent == child) {
      return leave_out(UrdfTree::Flaw::kDangling);
    }
    if (root_[joint].type == model::JointType::kGearbox) {
      tree_.gearboxes.push_back(joint);
      return;
    }
    Id<model::Joint>& carrier = tree_.carriers[child.value];
    if (carrier) return leave_out(UrdfTree::Flaw::kSecondParent, carrier);
    // The child is the root of its group, so that the parent, if it is in it, hangs on the child.
    if (!parent_is_world && groups_.together(parent, child)) {
      return leave_out(UrdfTree::Flaw::kCycle);
    }
    carrier = joint;
    tree_.edges.push_back({joint, parent, child});
    tree_.on_world |= parent_is_world;
    if (!parent_is_world) groups_.join(parent, child);
  }

  const model::Root& root_;
  const model::Frames& frames_;
  LinkGroups groups_;
  std::vector<bool> inside_;
  UrdfTree tree_;
};

}  // namespace

UrdfTree urdf_tree(const model::Root& root, const model::Frames& frames, Id<model::Model> model) {
  return UrdfTreeBuilder(root, frames).build(model);
}

}  // namespace rigor::convert
