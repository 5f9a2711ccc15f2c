// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The collisions with a closed form (no meshes) where they are at the start, and which of them are
// near each other.

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/mass/convex.h>
#include <rigor/model/frames.h>
#include <rigor/model/model.h>

namespace rigor::rules {

struct PlacedCollision {
  const model::Collision* collision;
  model::Id<model::Model> top;  ///< the outermost model that holds it
  bool fast;                    ///< its model is static, or its link kinematic
  mass::ConvexShape shape;
  mesh::Bounds bounds;  ///< in the frame of the poses
};

/// Per model the outermost that holds it.
inline std::vector<model::Id<model::Model>> top_models(const model::Root& root) {
  std::vector<model::Id<model::Model>> top(root.models.size());
  for (std::uint32_t m = 0; m < top.size(); ++m) {
    const auto parent = root.models[m].parent;  // stands before what it holds
    top[m] = parent && parent.value < m ? top[parent.value] : model::Id<model::Model>{m};
  }
  return top;
}

/// Whether each pose can be told. One that could not be read, and a name that leads nowhere, are told of
/// by other rules; what then lies at the origin is nobody's intention.
inline bool poses_are_known(const model::Root& root, const model::Frames& frames) {
  const auto known = [](const auto& list) {
    return std::all_of(list.begin(), list.end(), [](const auto& entity) {
      return entity.pose.pose.written || entity.pose.site.element == model::Site{}.element;
    });
  };
  return frames.problems().empty() && known(root.models) && known(root.links) &&
         known(root.joints) && known(root.frames) && known(root.collisions);
}

/// Whether its sizes are the file's, and not defaults in the place of what could not be read.
inline bool sizes_are_written(const model::Shape& shape) {
  const auto round = [](const auto& s) { return s.radius.written && s.length.written; };
  if (const auto* box = std::get_if<model::Box>(&shape)) return box->size.written;
  if (const auto* ball = std::get_if<model::Sphere>(&shape)) return ball->radius.written;
  if (const auto* cylinder = std::get_if<model::Cylinder>(&shape)) return round(*cylinder);
  if (const auto* capsule = std::get_if<model::Capsule>(&shape)) return round(*capsule);
  if (const auto* cone = std::get_if<model::Cone>(&shape)) return round(*cone);
  if (const auto* ball = std::get_if<model::Ellipsoid>(&shape)) return ball->radii.written;
  return false;
}

/// None where not every pose is known.
inline std::vector<PlacedCollision> placed_collisions(const model::Root& root,
                                                      const model::Frames& frames) {
  if (!poses_are_known(root, frames)) return {};
  const auto top = top_models(root);
  std::vector<bool> is_static(root.models.size());
  for (std::uint32_t m = 0; m < top.size(); ++m) {
    const auto parent = root.models[m].parent;
    is_static[m] =
        root.models[m].is_static.value || (parent && parent.value < m && is_static[parent.value]);
  }
  std::vector<PlacedCollision> placed;
  for (std::uint32_t i = 0; i < root.collisions.size(); ++i) {
    const model::Collision& collision = root.collisions[i];
    const model::Link& link = root[collision.link];
    const auto X_WS = frames.pose(model::Id<model::Collision>{i});
    if (!X_WS || !link.model || !sizes_are_written(collision.geometry.shape)) continue;
    const auto shape = mass::ConvexShape::of(collision.geometry.shape, *X_WS);
    if (!shape) continue;
    placed.push_back({&collision, top[link.model.value],
                      is_static[link.model.value] || link.kinematic.value, *shape,
                      shape->bounds()});
  }
  return placed;
}

/// Boxes that are compared in one file: some milliseconds. Shapes that all lie at one place make the
/// square of their number.
inline constexpr std::size_t kMostBoxPairs = 1'000'000;

/// Shapes that are compared in one file, likewise.
inline constexpr std::size_t kMostShapePairs = 5'000;

/// Every pair that may overlap by the boxes around it, and for which `matters` holds; up to the bounds
/// above. Sorts them along x.
template <class Matters, class Visit>
void for_near_pairs(std::vector<PlacedCollision>& placed, Matters matters, Visit visit) {
  std::sort(placed.begin(), placed.end(), [](const PlacedCollision& a, const PlacedCollision& b) {
    return std::pair(a.bounds.min.x, a.collision) < std::pair(b.bounds.min.x, b.collision);
  });
  std::size_t boxes = 0;
  std::size_t shapes = 0;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const PlacedCollision& a = placed[i];
    const mesh::Bounds& box = a.bounds;
    for (std::size_t j = i + 1; j < placed.size(); ++j) {
      const PlacedCollision& b = placed[j];
      if (b.bounds.min.x > box.max.x) break;
      if (++boxes > kMostBoxPairs) return;
      if (b.bounds.min.y > box.max.y || box.min.y > b.bounds.max.y) continue;
      if (b.bounds.min.z > box.max.z || box.min.z > b.bounds.max.z) continue;
      if (!matters(a, b)) continue;
      if (++shapes > kMostShapePairs) return;
      visit(a, b);
    }
  }
}

/// Which links joints connect.
class Linkage {
 public:
  Linkage(const model::Root& root, const model::Frames& frames) : body_(root.links.size()) {
    std::iota(body_.begin(), body_.end(), 0U);
    std::vector<Ends> hinges;
    for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
      const auto& ends = frames.ends({i});
      if (!ends.parent || !ends.child) continue;
      if (root.joints[i].type == model::JointType::kFixed) {
        join(ends.parent.value, ends.child.value);
      } else {
        hinges.emplace_back(ends.parent.value, ends.child.value);
      }
    }
    skip_links_without_shape(root, hinges);
    for (const auto& [parent, child] : hinges) {
      neighbours_.insert(std::minmax(body(parent), body(child)));
    }
  }

  /// Whether no joint moves one against the other, or one joint does. A link without a collision
  /// between two joints makes one joint of them, with two axes.
  bool are_neighbours(model::Id<model::Link> a, model::Id<model::Link> b) {
    const Ends pair = std::minmax(body(a.value), body(b.value));
    return pair.first == pair.second || neighbours_.contains(pair);
  }

 private:
  using Ends = std::pair<std::uint32_t, std::uint32_t>;

  std::uint32_t body(std::uint32_t link) {
    while (body_[link] != link) link = body_[link] = body_[body_[link]];
    return link;
  }
  void join(std::uint32_t parent, std::uint32_t child) { body_[body(child)] = body(parent); }

  void skip_links_without_shape(const model::Root& root, const std::vector<Ends>& hinges) {
    std::vector<bool> touchable(body_.size(), false);
    for (std::uint32_t i = 0; i < body_.size(); ++i) {
      if (!root.links[i].collisions.empty()) touchable[body(i)] = true;
    }
    for (const auto& [parent, child] : hinges) {
      const std::uint32_t before = body(parent);
      if (touchable[body(child)] || body(child) == before) continue;
      join(parent, child);
    }
  }

  std::vector<std::uint32_t> body_;
  std::set<Ends> neighbours_;
};

}  // namespace rigor::rules
