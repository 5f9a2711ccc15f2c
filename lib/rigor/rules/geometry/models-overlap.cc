// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/robot/placed_collisions.h>
#include <rigor/rules/geometry/world_shapes.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::models_overlap {

using ModelId = model::Id<model::Model>;

// Things that stand on each other are often drawn some millimeters into each other, and slide out.
constexpr double kDeep = 0.005;  // m
constexpr double kDeepShare = 0.05;

struct Neighbor {
  const model::Collision* own;
  const model::Collision* other;
  double depth;
};

/// By the model that moves, and of two that do the later one, then by the other.
using Found = std::map<ModelId, std::map<ModelId, Neighbor>>;

/// Models that a joint connects, or a plugin that makes one.
std::set<std::pair<ModelId, ModelId>> joined(const model::Root& root, const model::Frames& frames) {
  const auto top = robot::top_models(root);
  std::set<std::pair<ModelId, ModelId>> pairs;
  for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
    const auto& ends = frames.ends({i});
    if (!ends.parent || !ends.child) continue;
    const ModelId a = root[ends.parent].model, b = root[ends.child].model;
    if (a && b && top[a.value] != top[b.value]) {
      pairs.insert(std::minmax(top[a.value], top[b.value]));
    }
  }
  return pairs;
}

bool may_hold_others(const model::Root& root) {
  return std::any_of(root.plugins.begin(), root.plugins.end(), [](const model::Plugin& plugin) {
    return plugin.filename.value.find("detachable") != std::string::npos;
  });
}

Found find(const model::Root& root, Context& context) {
  std::vector<robot::PlacedCollision> placed = robot::placed_collisions(root, context.frames());
  const auto connected = joined(root, context.frames());
  Found found;
  robot::for_near_pairs(
      placed,
      [&](const robot::PlacedCollision& a, const robot::PlacedCollision& b) {
        return a.top != b.top && !(a.fast && b.fast) && root[a.top].world == root[b.top].world &&
               !connected.contains(std::minmax(a.top, b.top)) &&
               !is_choosy(*a.collision, context) && !is_choosy(*b.collision, context);
      },
      [&](const robot::PlacedCollision& a, const robot::PlacedCollision& b) {
        const double depth = mass::common_ball(a.shape, b.shape);
        const double smaller = 2 * std::min(a.shape.inradius(), b.shape.inradius());
        if (depth < kDeep || depth < kDeepShare * smaller) return;
        const bool a_moves = !a.fast && (b.fast || a.top > b.top);
        const robot::PlacedCollision& mover = a_moves ? a : b;
        const robot::PlacedCollision& other = a_moves ? b : a;
        Neighbor& pair = found[mover.top][other.top];
        if (depth <= pair.depth) return;
        pair = {mover.collision, other.collision,
                mass::refined_common_ball(a.shape, b.shape, depth)};
      });
  return found;
}

void check(const model::Root& root, Context& context) {
  if (root.worlds.empty() || root.models.size() < 2 || may_hold_others(root)) return;
  for (const auto& [id, others] : find(root, context)) {
    const auto where = place_of(root[id], root);
    if (!where) continue;
    const auto& [other, worst] = *std::max_element(
        others.begin(), others.end(),
        [](const auto& a, const auto& b) { return a.second.depth < b.second.depth; });
    Finding finding{
        .where = *where,
        .message = fmt::format("the model '{}' begins {:.2g} m deep in the model '{}'{}",
                               root[id].name.value, worst.depth, root[other].name.value,
                               others.size() == 1 ? "" : ", and in others"),
        .subject = context.subject(root[id])};
    for (const model::Collision* collision : {worst.own, worst.other}) {
      if (!root.own(collision->site)) continue;
      finding.related.push_back({collision->geometry.site.name,
                                 fmt::format("of '{}'", root[collision->link].name.value)});
    }
    context.report(std::move(finding));
  }
}

Rule rule() {
  return {
      .name = "models-overlap",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "models of a world begin inside each other",
      .why = "Models collide with each other in every engine. Those that overlap at the start are "
             "pushed apart at the first step, the faster the deeper; or one of them falls through "
             "a thin floor. Primitive shapes are checked, meshes are skipped.",
      .what_to_do = "Move one of them by its <pose>: the lowest point of one that rests on the "
                    "other is at the other's highest.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::models_overlap
