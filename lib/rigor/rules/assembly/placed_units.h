// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What moves with a pose of the file, as a unit: the link that it places and all that are placed from it.

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/robot/assembled/assembled.h>
#include <rigor/rules/context.h>

namespace rigor::rules {

/// A pose that places links: a URDF joint's, or an SDF link's.
struct PlacedUnit {
  const model::PoseField* pose = nullptr;
  model::Pose X_WL;                     ///< of what it places
  std::uint32_t link;                   ///< that it places
  const model::Joint* joint = nullptr;  ///< URDF
};

/// What moves with the poses of a file.
class MovedLinks {
 public:
  explicit MovedLinks(Context& context) : context_(context) {
    const model::Root& root = context.root();
    if (context.is_urdf()) return;
    for (std::uint32_t i = 0; i < root.links.size(); ++i) {
      const std::string& base = root.links[i].pose.relative_to.value;
      if (!base.empty()) placed_from_[{root.links[i].model.value, base}].push_back(i);
    }
  }

  /// The link that a pose places first, then a URDF's links behind it; of SDF those whose pose says `relative_to` this
  /// one, and so on. Through a joint or a frame they are not followed: then the unit is smaller than what moves.
  robot::Links with(std::uint32_t link) const {
    if (context_.is_urdf()) return context_.assembled().subtree(link);
    robot::Links found{link};
    const model::Root& root = context_.root();
    for (std::size_t i = 0; i < found.size(); ++i) {
      const model::Link& from = root.links[found[i]];
      const auto next = placed_from_.find({from.model.value, from.name.value});
      if (next == placed_from_.end()) continue;
      for (const std::uint32_t one : next->second) {
        if (one != found[i]) found.push_back(one);
      }
      if (found.size() > root.links.size()) return found;  // a cycle, which is reported elsewhere
    }
    return found;
  }

 private:
  Context& context_;
  // Of SDF, by model and name.
  std::map<std::pair<std::uint32_t, std::string_view>, robot::Links> placed_from_;
};

/// Whether a link that nothing shows and nothing touches, a frame, is where its parent is.
inline bool is_frame_of_parent(std::uint32_t link, Context& context) {
  const model::Link& frame = context.root().links[link];
  if (!frame.visuals.empty() || !frame.collisions.empty()) return false;
  const robot::Assembled& robot = context.assembled();
  const auto carrier = robot.links[link].carrier;
  if (!carrier) return false;
  const auto& X_WP = robot.links[context.frames().ends(carrier).parent.value].X_WL;
  const auto& X_WL = robot.links[link].X_WL;
  return X_WP && X_WL && X_WL->translation == X_WP->translation;
}

/// Whether two links are all that a root without shapes carries, and one is at its origin: the arms of a duo, of which
/// each may be anywhere.
inline bool are_a_duo(std::uint32_t a, std::uint32_t b, Context& context) {
  const robot::Assembled& robot = context.assembled();
  const auto root_of = [&](std::uint32_t link) {
    const auto carrier = robot.links[link].carrier;
    return carrier ? context.frames().ends(carrier).parent : model::Id<model::Link>{};
  };
  const auto parent = root_of(a);
  if (!parent || root_of(b) != parent || robot.links[parent.value].carrier) return false;
  const robot::AssembledLink& root = robot.links[parent.value];
  if (root.links_carried.size() != 2 || !root.shapes.empty() || !root.complete()) return false;
  const auto at_root = [&](std::uint32_t link) {
    return robot.links[link].X_WL && root.X_WL &&
           robot.links[link].X_WL->translation == root.X_WL->translation;
  };
  return at_root(a) || at_root(b);
}

/// The link that two are fixed to; nothing where one is not, or to another.
inline model::Id<model::Link> common_mount(std::uint32_t a, std::uint32_t b, Context& context) {
  const auto mount_of = [&](std::uint32_t link) {
    const auto carrier = context.assembled().links[link].carrier;
    if (!carrier || context.root()[carrier].type != model::JointType::kFixed)
      return model::Id<model::Link>{};
    return context.frames().ends(carrier).parent;
  };
  const auto mount = mount_of(a);
  return mount == mount_of(b) ? mount : model::Id<model::Link>{};
}

/// Whether two links are the eyes of a stereo camera: fixed to one link, one of them at its origin. What is between
/// them is the baseline; with the other's origin they would be in one place.
inline bool are_stereo_pair(std::uint32_t a, std::uint32_t b, Context& context) {
  const auto mount = common_mount(a, b, context);
  if (!mount) return false;
  const robot::Assembled& robot = context.assembled();
  const auto& X_WM = robot.links[mount.value].X_WL;
  const auto at_mount = [&](std::uint32_t link) {
    const auto& X_WL = robot.links[link].X_WL;
    return X_WM && X_WL && X_WL->translation == X_WM->translation;
  };
  return at_mount(a) || at_mount(b);
}

/// Whether it is one of two cameras that a short baseline keeps apart: small, and with nothing drawn between them.
inline bool is_eye(std::uint32_t link, Context& context) {
  constexpr double kBaseline = 0.3;  // m
  const robot::Assembled& robot = context.assembled();
  return std::any_of(
      robot.link_twins.begin(), robot.link_twins.end(), [&](const robot::Twins& pair) {
        if (pair.a != link && pair.b != link) return false;
        const auto &X_WA = robot.links[pair.a].X_WL, &X_WB = robot.links[pair.b].X_WL;
        return common_mount(pair.a, pair.b, context) && X_WA && X_WB &&
               length(X_WA->translation - X_WB->translation) < kBaseline;
      });
}

/// Whether nothing tells where the two belong: the arms of a duo, or frames of which one is where its parent is, as
/// that of one camera of two.
inline bool may_be_anywhere(std::uint32_t a, std::uint32_t b, Context& context) {
  return is_frame_of_parent(a, context) || is_frame_of_parent(b, context) ||
         are_a_duo(a, b, context) || are_stereo_pair(a, b, context);
}

/// Of the file itself, in its order.
inline std::vector<PlacedUnit> placed_units(Context& context) {
  const model::Root& root = context.root();
  const robot::Assembled& robot = context.assembled();
  std::vector<PlacedUnit> units;
  if (context.is_urdf()) {
    for (std::uint32_t j = 0; j < root.joints.size(); ++j) {
      const model::Joint& joint = root.joints[j];
      const auto& ends = context.frames().ends({j});
      if (!joint.pose.pose.written || !ends.parent || !ends.child) continue;
      const robot::AssembledLink& child = robot.links[ends.child.value];
      if (child.carrier.value != j || !child.X_WL) continue;
      units.push_back({&joint.pose, *child.X_WL, ends.child.value, &joint});
    }
    return units;
  }
  for (std::uint32_t i = 0; i < root.links.size(); ++i) {
    const model::Link& link = root.links[i];
    if (!root.own(link.site) || !link.pose.pose.written || !robot.links[i].X_WL) continue;
    units.push_back({&link.pose, *robot.links[i].X_WL, i, nullptr});
  }
  return units;
}

}  // namespace rigor::rules
