// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/placed_collisions.h>

#include <cstdint>
#include <variant>

namespace rigor::robot {
namespace {

/// Whether each pose can be told. One that could not be read, and a name that is undefined, are told of
/// by other rules; what then lies at the origin is nobody's intention.
bool poses_are_known(const model::Root& root, const model::Frames& frames) {
  const auto known = [](const auto& list) {
    return std::all_of(list.begin(), list.end(), [](const auto& entity) {
      return entity.pose.pose.written || entity.pose.site.element == model::Site{}.element;
    });
  };
  return frames.problems().empty() && known(root.models) && known(root.links) &&
         known(root.joints) && known(root.frames) && known(root.collisions);
}

}  // namespace

std::vector<model::Id<model::Model>> top_models(const model::Root& root) {
  std::vector<model::Id<model::Model>> top(root.models.size());
  for (std::uint32_t m = 0; m < top.size(); ++m) {
    const auto parent = root.models[m].parent;  // stands before what it holds
    top[m] = parent && parent.value < m ? top[parent.value] : model::Id<model::Model>{m};
  }
  return top;
}

bool sizes_are_written(const model::Shape& shape) {
  const auto round = [](const auto& s) { return s.radius.written && s.length.written; };
  if (const auto* box = std::get_if<model::Box>(&shape)) return box->size.written;
  if (const auto* ball = std::get_if<model::Sphere>(&shape)) return ball->radius.written;
  if (const auto* cylinder = std::get_if<model::Cylinder>(&shape)) return round(*cylinder);
  if (const auto* capsule = std::get_if<model::Capsule>(&shape)) return round(*capsule);
  if (const auto* cone = std::get_if<model::Cone>(&shape)) return round(*cone);
  if (const auto* ball = std::get_if<model::Ellipsoid>(&shape)) return ball->radii.written;
  return false;
}

std::vector<PlacedCollision> placed_collisions(const model::Root& root,
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

}  // namespace rigor::robot
