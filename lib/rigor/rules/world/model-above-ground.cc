// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstdint>
#include <map>
#include <variant>

#include <fmt/core.h>

#include <rigor/robot/placed_collisions.h>
#include <rigor/rules/geometry/world_shapes.h>
#include <rigor/rules/plugin/drive_wheels.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::model_above_ground {

using ModelId = model::Id<model::Model>;

// m; from half of it a robot survives, and authors set one down from a hand's height.
constexpr double kHigh = 0.5;

/// What may be below is not only what is placed here.
bool is_whole(const model::Root& root) {
  return std::all_of(root.includes.begin(), root.includes.end(),
                     [](const model::Include& include) { return include.followed; });
}

/// The outermost models with wheels that a plugin drives: no other is surely meant to stand.
std::map<ModelId, double> rovers(const model::Root& root, Context& context) {
  const auto top = robot::top_models(root);
  std::map<ModelId, double> found;
  for (const model::Plugin& plugin : root.plugins) {
    if (plugin.model && drive_of(plugin, context)) found.emplace(top[plugin.model.value], 0);
  }
  return found;
}

void check(const model::Root& root, Context& context) {
  if (root.worlds.empty() || root.plugins.empty() || !is_whole(root)) return;
  const auto robots = rovers(root, context);
  if (robots.empty()) return;
  const auto placed = robot::placed_collisions(root, context.frames());
  double ground = -1e9;
  bool known = false;
  for (std::uint32_t i = 0; i < root.collisions.size(); ++i) {
    const auto& shape = root.collisions[i].geometry.shape;
    const auto X_WC = context.frames().pose(model::Id<model::Collision>{i});
    if (std::holds_alternative<model::Heightmap>(shape) ||
        std::holds_alternative<model::Mesh>(shape))
      return;
    if (!std::holds_alternative<model::Plane>(shape) || !X_WC) continue;
    ground = std::max(ground, X_WC->translation.z);
    known = true;
  }
  if (!known) return;
  for (const auto& [id, unused] : robots) {
    const auto where = place_of(root[id], root);
    double lowest = 1e9;
    for (const auto& part : placed) {
      if (part.top == id) lowest = std::min(lowest, part.bounds.min.z);
    }
    if (!where || lowest > 1e8) continue;
    double below = ground;
    for (const auto& part : placed) {
      if (part.top != id && part.bounds.max.z <= lowest + 0.01)
        below = std::max(below, part.bounds.max.z);
    }
    if (lowest - below < kHigh) continue;
    context.report({.where = *where,
                    .message = fmt::format("the model '{}' begins {:.2g} m above what is below it",
                                           root[id].name.value, lowest - below),
                    .subject = context.subject(root[id])});
  }
}

Rule rule() {
  return {
      .name = "model-above-ground",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "a robot with driven wheels begins high above the ground",
      .why = "It falls, and lands on its side or in pieces. Reported is a model with a drive "
             "plugin whose lowest collision is more than half a meter above the ground plane and "
             "all that stands below its height; worlds with meshes or heightmaps are skipped.",
      .what_to_do = "Lower the model by that much with its <pose>.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::model_above_ground
