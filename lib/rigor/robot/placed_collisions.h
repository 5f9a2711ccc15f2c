// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The collisions with a closed form (no meshes) where they are at the start, and which of them are
// near each other.
//
//   std::vector<PlacedCollision> placed = placed_collisions(root, frames);
//   for_near_pairs(placed, matters, [&](const PlacedCollision& a, const PlacedCollision& b) { … });

#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <rigor/mass/convex.h>
#include <rigor/model/frames.h>
#include <rigor/model/model.h>

namespace rigor::robot {

struct PlacedCollision {
  const model::Collision* collision;
  model::Id<model::Model> top;  ///< the outermost model that holds it
  bool fast;                    ///< its model is static, or its link kinematic
  mass::ConvexShape shape;
  mesh::Bounds bounds;  ///< in the frame of the poses
};

/// Per model the outermost that holds it.
std::vector<model::Id<model::Model>> top_models(const model::Root& root);

/// Whether its sizes are the file's, and not defaults in the place of what could not be read.
bool sizes_are_written(const model::Shape& shape);

/// None where not every pose is known.
std::vector<PlacedCollision> placed_collisions(const model::Root& root,
                                               const model::Frames& frames);

/// Boxes that are compared in one file: some milliseconds. Shapes that all lie at one place make the
/// square of their number.
inline constexpr std::size_t kMaxBoxPairs = 1'000'000;

/// Shapes that are compared in one file, likewise.
inline constexpr std::size_t kMaxShapePairs = 5'000;

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
      if (++boxes > kMaxBoxPairs) return;
      if (b.bounds.min.y > box.max.y || box.min.y > b.bounds.max.y) continue;
      if (b.bounds.min.z > box.max.z || box.min.z > b.bounds.max.z) continue;
      if (!matters(a, b)) continue;
      if (++shapes > kMaxShapePairs) return;
      visit(a, b);
    }
  }
}

}  // namespace rigor::robot
