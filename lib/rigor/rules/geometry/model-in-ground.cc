// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include <rigor/robot/placed_collisions.h>
#include <rigor/rules/geometry/world_shapes.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::model_in_ground {

using model::Id;
using model::Vector3;

// Contacts rest some millimeters deep, as do cars whose wheels touch the ground by their nominal
// radius; from here on they push visibly.
constexpr double kDeep = 0.008;  // m

// A world has one ground, and perhaps some walls.
constexpr std::size_t kMaxPlanes = 8;

struct Ground {
  Vector3 point;
  Vector3 normal;  // unit vector, in the world's axes
  Id<model::World> world;
  Id<model::Model> top;  // none when it was not read
};

/// The two names under which every Gazebo finds its own ground.
bool is_ground_plane(std::string_view uri) {
  const std::size_t slash = uri.find_last_not_of('/');
  if (slash != uri.npos) uri = uri.substr(0, slash + 1);
  const std::string_view name = uri.substr(uri.find_last_of('/') + 1);
  return name == "ground_plane" || name == "Ground Plane" || name == "Ground%20Plane";
}

std::vector<Ground> grounds(const model::Root& root, const model::Frames& frames) {
  std::vector<Ground> found;
  const auto top = robot::top_models(root);
  for (std::uint32_t i = 0; i < root.collisions.size() && found.size() < kMaxPlanes; ++i) {
    const auto* plane = std::get_if<model::Plane>(&root.collisions[i].geometry.shape);
    const auto X_WP = frames.pose(Id<model::Collision>{i});
    if (plane == nullptr || !X_WP) continue;
    const Vector3 normal = rotate(X_WP->rotation, plane->normal.value);
    const auto model = root[root.collisions[i].link].model;
    if (!(length(normal) > 0) || !model) continue;
    const auto outermost = top[model.value];
    found.push_back(
        {X_WP->translation, (1 / length(normal)) * normal, root[outermost].world, outermost});
  }
  for (const model::Include& include : root.includes) {
    if (include.loaded || !include.world || found.size() == kMaxPlanes) continue;
    if (!is_ground_plane(include.uri.value) || !include.pose.relative_to.value.empty()) continue;
    const model::Pose& X_WP = include.pose.pose.value;
    found.push_back({X_WP.translation, rotate(X_WP.rotation, {0, 0, 1}), include.world, {}});
  }
  return found;
}

std::string in_words(double depth) {
  return depth < 10 ? fmt::format("{:.2g}", depth) : fmt::format("{:.0f}", depth);
}

struct Sunk {
  double depth = 0;
  const model::Collision* collision = nullptr;
};

void check(const model::Root& root, Context& context) {
  if (root.worlds.empty() || root.collisions.empty()) return;
  const std::vector<Ground> planes = grounds(root, context.frames());
  if (planes.empty()) return;
  std::map<Id<model::Model>, Sunk> sunk;
  for (const robot::PlacedCollision& placed : robot::placed_collisions(root, context.frames())) {
    if (placed.fast) continue;
    for (const Ground& ground : planes) {
      if (ground.top == placed.top || ground.world != root[placed.top].world) continue;
      const Vector3 lowest = placed.shape.farthest(-1 * ground.normal);
      const double depth = dot(ground.normal, ground.point - lowest);
      if (depth <= kDeep || is_choosy(*placed.collision, context)) continue;
      Sunk& deepest = sunk[placed.top];
      if (depth > deepest.depth) deepest = {depth, placed.collision};
    }
  }
  for (const auto& [id, deepest] : sunk) {
    const auto where = place_of(root[id], root);
    if (!where) continue;
    Finding finding{.where = *where,
                    .message = fmt::format("the model '{}' begins {} m deep in the ground",
                                           root[id].name.value, in_words(deepest.depth)),
                    .subject = context.subject(root[id])};
    if (root.own(deepest.collision->site)) {
      finding.related = {{deepest.collision->geometry.site.name, "its lowest collision"}};
    }
    context.report(std::move(finding));
  }
}

Rule rule() {
  return {
      .name = "model-in-ground",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "a model of a world begins inside the ground",
      .why = "All below a plane is solid for the engines: what begins there is thrown out at the "
             "first step, the faster the deeper, or stays caught. It is the pose of the model's "
             "middle that was given where that of its feet was meant, or none.",
      .what_to_do = "Raise the model by that much with its <pose>. `rigor simulate` shows how it "
                    "lands. Primitive shapes are checked, meshes are skipped.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::model_in_ground
