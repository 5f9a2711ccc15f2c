// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How links are joined to their parents, in numbers that can be compared between the joints of one robot:
// whether they touch, whether the joint is at the parent, and how much of the one is inside the others.
//
//   for (const Attached& one : AttachedLinks(context).find()) compare(one.fit, fit_of(one, shift_W));
//
// Boxes around shapes represent them, joints are at zero. Links that are rigidly fixed to each other count as one.

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <rigor/robot/assembled/travel.h>
#include <rigor/rules/assembly/placed_units.h>

namespace rigor::rules {

struct Fit {
  double gap = 0;     ///< m, between the link and all that does not move with its pose
  double reach = 0;   ///< m, from the joint to the shapes of the parent
  double inside = 0;  ///< share of the link that is inside of its parent, 0 to 1
};

struct Attached {
  PlacedUnit unit;
  robot::Links moved;                      ///< with its pose
  model::Vector3 pivot_W;                  ///< m, of the joint
  std::vector<robot::OrientedBox> child;   ///< of the link
  std::vector<robot::OrientedBox> parent;  ///< of what carries it
  std::vector<robot::OrientedBox> others;  ///< of what else does not move with it
  Fit fit;
};

/// How much of a link is inside of boxes, when it is moved by `d_W`, m.
inline double share_inside(const Attached& one, const model::Vector3& d_W,
                           const std::vector<robot::OrientedBox>& boxes) {
  double volume = 0, shared = 0;
  for (const robot::OrientedBox& box : one.child) {
    const double size = box.half[0] * box.half[1] * box.half[2];
    volume += size;
    shared += size * robot::share_inside(robot::moved(box, d_W), boxes);
  }
  return volume > 0 ? shared / volume : 0;
}

/// m, between the link moved by `d_W` and boxes; no more than `least`.
inline double gap_to(const std::vector<robot::OrientedBox>& boxes, const Attached& one,
                     const model::Vector3& d_W, double least) {
  for (const robot::OrientedBox& still : one.child) {
    const robot::OrientedBox box = robot::moved(still, d_W);
    for (const robot::OrientedBox& other : boxes) {
      if (least <= 0) return 0;
      const double apart = model::length(other.center_W - box.center_W);
      if (apart - (robot::diameter(box) + robot::diameter(other)) / 2 >= least) continue;
      least = std::min(least, std::max(0.0, robot::separation(box, other)));
    }
  }
  return least;
}

inline double reach_of(const Attached& one, const model::Vector3& d_W) {
  double least = std::numeric_limits<double>::infinity();
  for (const robot::OrientedBox& box : one.parent)
    least = std::min(least, robot::distance(box, one.pivot_W + d_W));
  return least;
}

/// How it would be joined if its pose were moved by `d_W`, m.
inline Fit fit_of(const Attached& one, const model::Vector3& d_W) {
  const double of_parent = gap_to(one.parent, one, d_W, std::numeric_limits<double>::infinity());
  const double gap = of_parent > 0 ? gap_to(one.others, one, d_W, of_parent) : 0;
  const double inside = of_parent > 0 ? 0 : share_inside(one, d_W, one.parent);
  return {gap, reach_of(one, d_W), inside};
}

/// Makes the list, for the models of the file that are not too large to compare each link with all others.
class AttachedLinks {
 public:
  explicit AttachedLinks(Context& context)
      : context_(context),
        robot_(context.assembled()),
        rigid_(context.root(), context.frames(), robot_) {}

  const robot::RigidGroups& rigid() const { return rigid_; }

  std::vector<Attached> find() {
    std::vector<Attached> result;
    constexpr std::size_t kMaxShapes = 600;
    constexpr std::size_t kMaxLinks = 2000;
    if (robot_.shapes.size() < 2 || robot_.shapes.size() > kMaxShapes) return result;
    if (robot_.links.size() > kMaxLinks) return result;
    const MovedLinks moved(context_);
    for (const PlacedUnit& unit : placed_units(context_)) {
      if (auto one = attached(unit, moved)) result.push_back(*std::move(one));
    }
    return result;
  }

 private:
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

  std::optional<Attached> attached(const PlacedUnit& unit, const MovedLinks& moved_links) {
    const robot::AssembledLink& link = robot_.links[unit.link];
    if (!link.carrier) return std::nullopt;
    const auto& ends = context_.frames().ends(link.carrier);
    const auto X_WJ = context_.frames().pose(link.carrier);
    if (!ends.parent || !X_WJ) return std::nullopt;
    if (!has_known_body(ends.parent.value)) return std::nullopt;
    Attached one{unit, moved_links.with(unit.link), X_WJ->translation, {}, {}, {}, {}};
    std::vector<bool> moved(robot_.links.size(), false);
    for (const std::uint32_t i : one.moved) moved[i] = true;
    if (moved[ends.parent.value]) return std::nullopt;
    const std::uint32_t parent = rigid_.leaders[ends.parent.value];
    constexpr std::size_t kUsual = 8;
    one.child.reserve(kUsual);
    one.parent.reserve(kUsual);
    for (const robot::AssembledShape& shape : robot_.shapes) {
      if (moved[shape.link]) {
        if (rigid_.is_fixed_to(shape.link, one.unit.link)) one.child.push_back(shape.box_W);
      } else if (rigid_.leaders[shape.link] == parent) {
        one.parent.push_back(shape.box_W);
      }
    }
    // What is not known of the parent may be where the joint is.
    if (one.parent.empty() || one.child.empty()) return std::nullopt;
    if (!is_plain(one)) add_others(moved, parent, link.top, one);
    return one;
  }

  /// Whether it meets its parent, as nearly all do, and its middle is not within it: then the rest of the
  /// robot says no more.
  bool is_plain(const Attached& one) const {
    if (gap_to(one.parent, one, {}, std::numeric_limits<double>::infinity()) > 0) return false;
    if (reach_of(one, {}) > 0) return false;
    for (const robot::OrientedBox& box : one.child) {
      for (const robot::AssembledShape& shape : robot_.shapes) {
        if (shape.link == one.unit.link ||
            model::length(shape.box_W.center_W - box.center_W) > shape.radius)
          continue;
        if (robot_.links[shape.link].top == robot_.links[one.unit.link].top &&
            robot::contains(shape.box_W, box.center_W))
          return false;
      }
    }
    return true;
  }

  void add_others(const std::vector<bool>& moved, std::uint32_t parent, model::Id<model::Model> top,
                  Attached& one) const {
    for (const robot::AssembledShape& shape : robot_.shapes) {
      if (moved[shape.link] || rigid_.leaders[shape.link] == parent) continue;
      if (robot_.links[shape.link].top == top) one.others.push_back(shape.box_W);
    }
    one.fit = fit_of(one, {});
  }

  Context& context_;
  const robot::Assembled& robot_;
  robot::RigidGroups rigid_;
};

}  // namespace rigor::rules
