// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Links of one model that are in each other at the start, and no neighbours: pairs that an engine
// which lets a model's links collide pushes apart.

#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/read/values.h>
#include <rigor/rules/context.h>
#include <rigor/rules/geometry/placed_shapes.h>

namespace rigor::rules {

// What is drawn to touch overlaps by a rounding; of what is deeper than this, and than a share of the
// smaller shape, one is in the other. The simulator's own tests call 2 mm a failure.
inline constexpr double kDeep = 0.002;  // m
inline constexpr double kDeepShare = 0.1;

struct LinkOverlap {
  const model::Collision* a;
  const model::Collision* b;
  double depth;  ///< m, diameter of the ball that fits into both
};

inline bool is_deep(const PlacedCollision& a, const PlacedCollision& b, double depth) {
  const double smaller = 2 * std::min(a.shape.inradius(), b.shape.inradius());
  return depth > kDeep && depth > kDeepShare * smaller;
}

/// By outermost model, the pairs of links, each with its deepest shapes, in the order of the file.
using LinkOverlaps = std::map<model::Id<model::Model>, std::vector<LinkOverlap>>;

inline LinkOverlaps overlapping_links(const model::Root& root, const model::Frames& frames) {
  std::vector<PlacedCollision> placed = placed_collisions(root, frames);
  Linkage linkage(root, frames);
  using Links = std::pair<model::Id<model::Link>, model::Id<model::Link>>;
  std::map<model::Id<model::Model>, std::map<Links, LinkOverlap>> found;
  for_near_pairs(
      placed,
      [&](const PlacedCollision& a, const PlacedCollision& b) {
        return a.top == b.top && !a.fast && !b.fast &&
               !linkage.are_neighbours(a.collision->link, b.collision->link);
      },
      [&](const PlacedCollision& a, const PlacedCollision& b) {
        const double depth = mass::common_ball(a.shape, b.shape);
        if (!is_deep(a, b, depth)) return;
        const bool in_order = a.collision->link < b.collision->link;
        const PlacedCollision& first = in_order ? a : b;
        const PlacedCollision& second = in_order ? b : a;
        LinkOverlap& pair = found[a.top][{first.collision->link, second.collision->link}];
        if (depth > pair.depth) pair = {first.collision, second.collision, depth};
      });
  LinkOverlaps result;
  for (const auto& [top, pairs] : found) {
    for (const auto& [links, pair] : pairs) result[top].push_back(pair);
  }
  return result;
}

/// The least that a joint has to move to be within its limits, for those that are not at zero.
inline model::JointPositions nearest_within_limits(const model::Root& root) {
  model::JointPositions positions;
  for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
    const model::Joint& joint = root.joints[i];
    if (joint.axes.empty() || joint.type == model::JointType::kFixed) continue;
    std::array<double, 2> at{};
    for (std::size_t axis = 0; axis < std::min<std::size_t>(joint.axes.size(), 2); ++axis) {
      const auto& [lower, upper] = std::pair(joint.axes[axis].lower, joint.axes[axis].upper);
      if (lower.written && lower.value > 0) at[axis] = lower.value;
      if (upper.written && upper.value < 0) at[axis] = upper.value;
    }
    if (at != std::array<double, 2>{}) {
      positions[model::scoped_name(root, model::Id<model::Joint>{i})] = at;
    }
  }
  return positions;
}

/// Those that overlap at the start as well as where all joints are within their limits.
inline LinkOverlaps lasting_overlaps(const model::Root& root, const model::Frames& frames) {
  LinkOverlaps found = overlapping_links(root, frames);
  if (found.empty()) return found;
  const model::JointPositions positions = nearest_within_limits(root);
  if (positions.empty()) return found;
  return overlapping_links(root, model::Frames(root, positions));
}

/// Links whose `self_collide` (in URDF a `<gazebo>` block's) is true, and those of models where it is.
class SelfColliding {
 public:
  SelfColliding(const model::Root& root, const Context& context) : root_(root), context_(context) {
    if (!context.is_urdf()) {
      for (const model::Model& model : root.models) {
        models_.push_back(root.own(model.site) && model.self_collide.value);
      }
      return;
    }
    for (const model::GazeboBlock& block : root.gazebo_blocks) {
      if (!root.own(block.site) || !is_flagged(block)) continue;
      if (block.reference.value.empty()) all_ = true;
      blocks_.push_back(block.reference.value);
    }
  }

  bool any() const {
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
      if ((*this)(model::Id<model::Link>{i})) return true;
    }
    return false;
  }

  bool operator()(model::Id<model::Link> id) const {
    const model::Link& link = root_[id];
    if (context_.is_urdf()) {
      return all_ || std::find(blocks_.begin(), blocks_.end(), link.name.value) != blocks_.end();
    }
    if (!root_.own(link.site)) return false;
    return link.self_collide.written ? link.self_collide.value : models_[link.model.value];
  }

 private:
  static bool is_flagged(const model::GazeboBlock& block) {
    for (const std::string_view name : {"self_collide", "selfCollide"}) {
      const auto* flag = find(block.content, name);
      if (flag != nullptr && read::bool_field(*flag).value) return true;
    }
    return false;
  }

  const model::Root& root_;
  const Context& context_;
  bool all_ = false;
  std::vector<std::string_view> blocks_;
  std::vector<bool> models_;
};

/// Whether the two may touch: one that collides with its own model is enough.
inline bool self_collide(const LinkOverlap& pair, const SelfColliding& self_colliding) {
  return self_colliding(pair.a->link) || self_colliding(pair.b->link);
}

/// One finding for a model, which names the pair that is deepest in each other.
inline void report_overlaps(const model::Model& model, const std::vector<LinkOverlap>& pairs,
                            std::string_view where, Context& context) {
  if (pairs.empty()) return;
  const model::Root& root = context.root();
  const LinkOverlap& worst = *std::max_element(
      pairs.begin(), pairs.end(),
      [](const LinkOverlap& a, const LinkOverlap& b) { return a.depth < b.depth; });
  const std::string others = pairs.size() == 1
                                 ? std::string()
                                 : fmt::format("; {} more pair{} too", pairs.size() - 1,
                                               pairs.size() == 2 ? " does" : "s do");
  Finding finding{
      .where = model.site.name,
      .message = fmt::format(
          "the links '{}' and '{}' overlap by {:.2g} m {}, and no joint connects them{}",
          root[worst.a->link].name.value, root[worst.b->link].name.value, worst.depth, where,
          others),
      .subject = context.subject(model)};
  for (const model::Collision* collision : {worst.a, worst.b}) {
    if (!root.own(collision->site)) continue;
    finding.related.push_back(
        {collision->geometry.site.name, fmt::format("of '{}'", root[collision->link].name.value)});
  }
  context.report(std::move(finding));
}

}  // namespace rigor::rules
