// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/tree.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include <rigor/convert/written_number.h>
#include <rigor/robot/swapped_joints.h>
#include <rigor/text/letter_case.h>

namespace rigor::convert {
namespace {

using model::Id;

bool is_called_joint(const model::Frame& frame) {
  return lowered(frame.name.value).find("joint") != std::string::npos;
}

class UrdfTreeBuilder {
 public:
  UrdfTreeBuilder(const model::Root& root, const model::Frames& frames)
      : root_(root), frames_(frames) {}

  UrdfTree build(Id<model::Model> top) && {
    find_parts(top);
    find_fixed_joints();
    tree_.carriers.resize(root_.links.size());
    for (std::uint32_t i = 0; i < root_.joints.size(); ++i) {
      if (is_inside(root_.joints[i].model)) look_at({i});
    }
    hang();
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

  /// The frame that another is attached to; none when that is no frame.
  Id<model::Frame> base_of(Id<model::Frame> id) const {
    const model::Frame& frame = root_[id];
    if (frame.attached_to.value.empty()) return {};
    const model::Named named = frames_.names().find({frame.model, {}}, frame.attached_to.value);
    const auto* base = std::get_if<Id<model::Frame>>(&named);
    return base != nullptr ? *base : Id<model::Frame>{};
  }

  /// As a conversion writes a joint and the link on it. A frame holds a pose at most, and an element's index
  /// is one more than that of the one before it.
  bool is_next_to(const model::Frame& first, const model::Frame& second) const {
    const std::string& base = first.pose.relative_to.value;
    if (!base.empty() && base != first.attached_to.value) return false;
    const std::uint32_t next = first.site.element + (first.pose.site.span.nowhere() ? 1 : 2);
    return first.site.span.source == second.site.span.source && second.site.element == next;
  }

  void find_fixed_joints() {
    const ReferredNames referred = referred_names(root_);
    std::map<Id<model::Frame>, int> attached;
    for (const Id<model::Frame> id : tree_.frames) {
      if (const Id<model::Frame> base = base_of(id)) ++attached[base];
    }
    std::set<Id<model::Frame>> on_joints;
    for (const Id<model::Frame> id : tree_.frames) {
      const Id<model::Frame> joint = base_of(id);
      if (!joint || attached[joint] != 1 || on_joints.contains(joint)) continue;
      const model::Frame& below = root_[joint];
      const model::Frame& frame = root_[id];
      const bool apart =
          !frame.pose.relative_to.value.empty() || !is_identity(frame.pose.pose.value);
      if (apart || below.model != frame.model) continue;
      const bool in_place = !is_called_joint(frame) && is_next_to(below, frame);
      if (!in_place && !is_called_joint(below)) continue;
      // Joints and links alternate: whatever this joint is called, the next is not on its link's frame.
      on_joints.insert(id);
      if (may_be_joint(below, in_place, referred)) tree_.fixed_by.emplace(id, joint);
    }
  }

  bool is_part(Id<model::Link> link) const { return link && is_inside(root_[link].model); }

  void look_at(Id<model::Joint> joint) {
    const auto& [parent, child, parent_is_world] = frames_.ends(joint);
    if (!is_part(child) || !(parent_is_world || is_part(parent)) || parent == child) {
      tree_.left_out.push_back({joint, UrdfTree::Flaw::kDangling, {}});
    } else if (root_[joint].type == model::JointType::kGearbox) {
      tree_.gearboxes.push_back(joint);
    } else {
      joints_.push_back(joint);
      edges_.push_back({parent_is_world ? world() : parent.value, child.value,
                        robot::can_turn(root_[joint].type)});
    }
  }

  std::uint32_t world() const { return static_cast<std::uint32_t>(root_.links.size()); }

  void hang() {
    const std::vector<robot::Edge::Direction> directions =
        robot::edge_directions(edges_, root_.links.size() + 1, world());
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (directions[i] == robot::Edge::Direction::kLeftOut) continue;
      const bool turned = directions[i] == robot::Edge::Direction::kTurned;
      const bool on_world = edges_[i].parent == world();
      Id<model::Link> parent = on_world ? Id<model::Link>{} : Id<model::Link>{edges_[i].parent};
      Id<model::Link> child{edges_[i].child};
      if (turned) std::swap(parent, child);
      tree_.edges.push_back({joints_[i], parent, child, turned});
      tree_.carriers[child.value] = joints_[i];
      tree_.on_world |= on_world;
    }
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (directions[i] != robot::Edge::Direction::kLeftOut) continue;
      const Id<model::Joint> carrier = tree_.carriers[edges_[i].child];
      tree_.left_out.push_back(
          {joints_[i], carrier ? UrdfTree::Flaw::kSecondParent : UrdfTree::Flaw::kCycle, carrier});
    }
    std::sort(tree_.left_out.begin(), tree_.left_out.end(),
              [](const auto& a, const auto& b) { return a.joint.value < b.joint.value; });
  }

  const model::Root& root_;
  const model::Frames& frames_;
  std::vector<bool> inside_;
  std::vector<Id<model::Joint>> joints_;  // of each limb
  std::vector<robot::Edge> edges_;
  UrdfTree tree_;
};

}  // namespace

ReferredNames referred_names(const model::Root& root) {
  ReferredNames names;
  const auto add = [&names](Id<model::Model> model, const std::string& name) {
    if (!name.empty()) names.emplace(model.value, name);
  };
  const auto add_places = [&add](const auto& all) {
    for (const auto& one : all) add(one.model, one.pose.relative_to.value);
  };
  add_places(root.links);
  add_places(root.joints);
  add_places(root.frames);
  for (const model::Joint& joint : root.joints) {
    add(joint.model, joint.parent.value);
    add(joint.model, joint.child.value);
  }
  return names;
}

bool may_be_joint(const model::Frame& frame, bool is_next_to, const ReferredNames& referred) {
  if (is_called_joint(frame)) return true;
  const std::string name = lowered(frame.name.value);
  const auto holds = [&name](std::string_view word) {
    return name.find(word) != std::string::npos;
  };
  // `base_link_to_camera` is no link.
  const bool is_called_link = (holds("link") || holds("frame")) && !holds("_to_") && !holds("fix");
  return is_next_to && !is_called_link && !referred.contains({frame.model.value, frame.name.value});
}

UrdfTree urdf_tree(const model::Root& root, const model::Frames& frames, Id<model::Model> model) {
  return UrdfTreeBuilder(root, frames).build(model);
}

}  // namespace rigor::convert
