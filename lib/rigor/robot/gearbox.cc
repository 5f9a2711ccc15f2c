// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/gearbox.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

namespace rigor::robot {
namespace {

using model::Id;
using model::JointType;

/// Axes are along each other within this sine. Files have 1.57 for a right angle, off by 8e-4; such a slant changes
/// the ratio by half its square.
constexpr double kParallel = 2e-3;

class GearFinder {
 public:
  GearFinder(const model::Root& root, const model::Frames& frames) : root_(root), frames_(frames) {
    for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
      const model::Joint& joint = root.joints[i];
      const model::Frames::Ends& ends = frames.ends({i});
      const bool hinge = joint.type == JointType::kRevolute || joint.type == JointType::kContinuous;
      if (hinge && ends.parent && ends.child) {
        hinges_.try_emplace({ends.parent.value, ends.child.value}, i);
      }
      for (const model::Axis& axis : joint.axes) {
        if (!axis.mimic) continue;
        if (const auto leader = leader_of(joint, *axis.mimic)) leaders_.emplace(i, leader.value);
      }
    }
  }

  std::optional<GearCoupling> find(Id<model::Joint> gearbox) {
    const model::Joint& joint = root_[gearbox];
    const Id<model::Link> reference =
        joint.model ? frames_.names().find_link(joint.model, joint.gearbox_reference.value)
                    : Id<model::Link>{};
    const model::Frames::Ends& ends = frames_.ends(gearbox);
    if (!reference || joint.gearbox_ratio.value == 0) return std::nullopt;
    const auto first = between(reference, ends.parent, gearbox, 0);
    const auto second = between(reference, ends.child, gearbox, 1);
    if (!first || !second || leaders_.contains(second->joint.value)) return std::nullopt;
    if (follows(first->joint.value, second->joint.value)) return std::nullopt;
    leaders_.emplace(second->joint.value, first->joint.value);
    return GearCoupling{gearbox, first->joint, second->joint,
                        -joint.gearbox_ratio.value * first->sign * second->sign};
  }

 private:
  struct Coupled {
    Id<model::Joint> joint;
    double sign;  ///< of the joint's angle in the gearbox's
  };

  Id<model::Joint> leader_of(const model::Joint& joint, const model::Mimic& mimic) const {
    return joint.model ? frames_.names().find_joint(joint.model, mimic.joint.value)
                       : Id<model::Joint>{};
  }

  std::optional<Coupled> between(Id<model::Link> reference, Id<model::Link> end,
                                 Id<model::Joint> gearbox, std::size_t k) const {
    if (!end) return std::nullopt;
    double sign = 1;
    auto found = hinges_.find({reference.value, end.value});
    if (found == hinges_.end()) {
      found = hinges_.find({end.value, reference.value});
      sign = -1;
    }
    if (found == hinges_.end()) return std::nullopt;
    const Id<model::Joint> id{found->second};
    const auto axis = frames_.axis(id, 0);
    const auto own = frames_.axis(gearbox, k);
    if (!axis || !own || length(cross(*axis, *own)) > kParallel) return std::nullopt;
    return Coupled{id, dot(*axis, *own) < 0 ? -sign : sign};
  }

  /// What follows has one leader. A ring of mimics is walked once.
  bool follows(std::uint32_t joint, std::uint32_t leader) const {
    for (std::size_t steps = 0; steps <= leaders_.size(); ++steps) {
      if (joint == leader) return true;
      const auto found = leaders_.find(joint);
      if (found == leaders_.end()) return false;
      joint = found->second;
    }
    return true;
  }

  const model::Root& root_;
  const model::Frames& frames_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> hinges_;  // by parent and child
  std::map<std::uint32_t, std::uint32_t> leaders_;                           // by follower
};

}  // namespace

std::vector<GearCoupling> gear_couplings(const model::Root& root, const model::Frames& frames) {
  const auto is_gearbox = [](const model::Joint& joint) {
    return joint.type == JointType::kGearbox;
  };
  if (std::none_of(root.joints.begin(), root.joints.end(), is_gearbox)) return {};
  GearFinder finder(root, frames);
  std::vector<GearCoupling> found;
  for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
    if (!is_gearbox(root.joints[i])) continue;
    if (const auto coupling = finder.find({i})) found.push_back(*coupling);
  }
  return found;
}

}  // namespace rigor::robot
