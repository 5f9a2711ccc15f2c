// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How links are joined to their parents, in numbers that can be compared between the joints of one robot:
// whether they touch, whether the joint is at the parent, and how much of the one is inside the others.
//
//   for (const Attached& one : AttachedLinks(context).find()) compare(one.fit, fit_of(one, shift_W));
//
// Boxes around shapes stand for them, joints are at zero. Links that are rigidly fixed to each other count as one.

#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <rigor/rules/assembly/placed_units.h>

namespace rigor::rules {

struct Fit {
  double gap = 0;     ///< m, between the link and all that does not move with its pose
  double reach = 0;   ///< m, from the joint to the shapes of the parent
  double inside = 0;  ///< share of the link that is inside of others, 0 to 1
};

struct Attached {
  PlacedUnit unit;
  model::Vector3 pivot_W;                  ///< m, of the joint
  std::vector<robot::OrientedBox> child;   ///< of the link
  std::vector<robot::OrientedBox> parent;  ///< of what carries it
  std::vector<robot::OrientedBox> others;  ///< of all that is not moved with it, the parent's too
  Fit fit;
};

/// How it would be joined if its pose were moved by `d_W`, m.
inline Fit fit_of(const Attached& one, const model::Vector3& d_W) {
  Fit result{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), 0};
  double volume = 0, shared = 0;
  for (const robot::OrientedBox& still : one.child) {
    const robot::OrientedBox box = robot::moved(still, d_W);
    const double size = box.half[0] * box.half[1] * box.half[2];
    volume += size;
    shared += size * robot::share_inside(box, one.others);
    for (const robot::OrientedBox& other : one.others) {
      if (result.gap <= 0) break;
      const double apart = model::length(other.center_W - box.center_W);
      if (apart - (robot::diameter(box) + robot::diameter(other)) / 2 >= result.gap) continue;
      result.gap = std::min(result.gap, std::max(0.0, robot::separation(box, other)));
    }
  }
  for (const robot::OrientedBox& box : one.parent)
    result.reach = std::min(result.reach, robot::distance(box, one.pivot_W + d_W));
  if (volume > 0) result.inside = shared / volume;
  return result;
}

/// Makes the list, for the models of the file that are not too large to compare each link with all others.
class AttachedLinks {
 public:
  explicit AttachedLinks(Context& context)
      : context_(context), robot_(context.assembled()), group_(robot_.links.size()) {
    for (std::uint32_t i = 0; i < group_.size(); ++i) group_[i] = i;
    const model::Root& root = context.root();
    for (std::uint32_t j = 0; j < root.joints.size(); ++j) {
      const auto& ends = context.frames().ends({j});
      if (root.joints[j].type != model::JointType::kFixed || !ends.parent || !ends.child) continue;
      if (robot_.links[ends.child.value].carrier.value != j) continue;
      group_[ends.child.value] = ends.parent.value;  // resolved by leader()
    }
  }

  std::vector<Attached> find() {
    std::vector<Attached> result;
    constexpr std::size_t kMostShapes = 600;
    if (robot_.shapes.size() < 2 || robot_.shapes.size() > kMostShapes) return result;
    for (PlacedUnit& unit : placed_units(context_)) {
      if (auto one = attached(std::move(unit))) result.push_back(*std::move(one));
    }
    return result;
  }

 private:
  /// The link that carries all that is fixed to this one.
  std::uint32_t leader(std::uint32_t link) const {
    for (std::size_t steps = 0; group_[link] != link && steps < group_.size(); ++steps)
      link = group_[link];
    return link;
  }

  /// Whether all that can be seen, or all that can be touched, is known of a link: either is its body.
  bool has_known_body(std::uint32_t i) const {
    const robot::AssembledLink& link = robot_.links[i];
    if (link.complete()) return true;
    const model::Link& of = context_.root().links[i];
    const auto known = [&](robot::ShapeRole role) {
      return static_cast<std::size_t>(
          std::count_if(link.shapes.begin(), link.shapes.end(),
                        [&](std::uint32_t s) { return robot_.shapes[s].role == role; }));
    };
    const std::size_t touched = known(robot::ShapeRole::kCollision);
    const std::size_t seen = known(robot::ShapeRole::kVisual);
    return (touched > 0 && touched == of.collisions.size()) ||
           (seen > 0 && seen == of.visuals.size());
  }

  /// Whether a link is fixed to another, which carries it.
  bool is_fixed_to(std::uint32_t link, std::uint32_t base) const {
    for (std::size_t steps = 0; link != base && steps < group_.size(); ++steps) {
      if (group_[link] == link) return false;
      link = group_[link];
    }
    return link == base;
  }

  std::optional<Attached> attached(PlacedUnit unit) {
    const robot::AssembledLink& link = robot_.links[unit.link];
    if (!link.carrier) return std::nullopt;
    const auto& ends = context_.frames().ends(link.carrier);
    const auto X_WJ = context_.frames().pose(link.carrier);
    if (!ends.parent || !X_WJ) return std::nullopt;
    Attached one{std::move(unit), X_WJ->translation, {}, {}, {}, {}};
    std::vector<bool> moved(robot_.links.size(), false);
    for (const std::uint32_t i : one.unit.moved) moved[i] = true;
    if (moved[ends.parent.value]) return std::nullopt;
    const std::uint32_t parent = leader(ends.parent.value);
    for (const robot::AssembledShape& shape : robot_.shapes) {
      if (moved[shape.link] && is_fixed_to(shape.link, one.unit.link))
        one.child.push_back(shape.box_W);
      if (moved[shape.link] || robot_.links[shape.link].top != link.top) continue;
      one.others.push_back(shape.box_W);
      if (leader(shape.link) == parent) one.parent.push_back(shape.box_W);
    }
    // What is not known of the parent may be where the joint is.
    if (one.parent.empty() || one.child.empty() || !has_known_body(ends.parent.value))
      return std::nullopt;
    one.fit = fit_of(one, {});
    return one;
  }

  Context& context_;
  const robot::Assembled& robot_;
  std::vector<std::uint32_t> group_;  // of each link, what it is fixed to
};

}  // namespace rigor::rules
