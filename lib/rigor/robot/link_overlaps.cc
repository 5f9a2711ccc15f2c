// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/link_overlaps.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <rigor/robot/linkage.h>
#include <rigor/robot/placed_collisions.h>

namespace rigor::robot {
namespace {

// What is drawn to touch overlaps by a rounding; of what is deeper than this, and than a share of the
// smaller shape, one is in the other. The simulator's own tests call 2 mm a failure.
constexpr double kDeep = 0.002;  // m
constexpr double kDeepShare = 0.1;

bool is_deep(const PlacedCollision& a, const PlacedCollision& b, double depth) {
  const double smaller = 2 * std::min(a.shape.inradius(), b.shape.inradius());
  return depth > kDeep && depth > kDeepShare * smaller;
}

/// The least that a joint has to move to be within its limits, for those that are not at zero.
model::JointPositions nearest_within_limits(const model::Root& root) {
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

}  // namespace

LinkOverlaps overlapping_links(const model::Root& root, const model::Frames& frames) {
  std::vector<PlacedCollision> placed = placed_collisions(root, frames);
  Linkage linkage(root, frames);
  using TwoLinks = std::pair<model::Id<model::Link>, model::Id<model::Link>>;
  std::map<model::Id<model::Model>, std::map<TwoLinks, LinkOverlap>> found;
  for_near_pairs(
      placed,
      [&](const PlacedCollision& a, const PlacedCollision& b) {
        return a.top == b.top && !a.fast && !b.fast &&
               !linkage.are_neighbors(a.collision->link, b.collision->link);
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

LinkOverlaps lasting_overlaps(const model::Root& root, const model::Frames& frames) {
  LinkOverlaps found = overlapping_links(root, frames);
  if (found.empty()) return found;
  const model::JointPositions positions = nearest_within_limits(root);
  if (positions.empty()) return found;
  return overlapping_links(root, model::Frames(root, positions));
}

}  // namespace rigor::robot
