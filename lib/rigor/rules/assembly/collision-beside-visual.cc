// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstdint>

#include <fmt/core.h>

#include <rigor/rules/assembly/seen_shapes.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::collision_beside_visual {

// What both share of the smaller one's box. Bumpers and feet may cover little of a link, and they are in it.
constexpr double kCovered = 0.05;

// A link that shows a mark or a light, beside a body that is not drawn.
constexpr double kToken = 0.01;  // of the other's size

// What stands for a frame, such as the millimeter cube that PR2's base_footprint collides as.
constexpr double kSpeck = 0.005;  // m

/// All that is touched, or all that is seen, in the frame of the link.
struct Reach {
  bool any = false;
  mesh::Bounds bounds;

  void add(const mesh::Bounds& box) {
    bounds = any ? robot::joined(bounds, box) : box;
    any = true;
  }
};

void check(const model::Root& root, Context& context) {
  for (std::uint32_t i = 0; i < root.links.size(); ++i) {
    const model::Link& link = root.links[i];
    if (link.collisions.empty() || link.visuals.empty() || !root.own(link.site)) continue;
    if (!context.assembled().links[i].complete()) continue;
    Reach touched, seen;
    for (const SeenShape& one : seen_shapes(i, context)) {
      (one.is_collision() ? touched : seen).add(one.bounds_L);
    }
    if (!touched.any || !seen.any) continue;
    const double share = robot::cover(touched.bounds, seen.bounds);
    if (share > kCovered) continue;
    const double a = mesh::diagonal(touched.bounds), b = mesh::diagonal(seen.bounds);
    if (std::min(a, b) < std::max(kSpeck, kToken * std::max(a, b))) continue;
    // Thin ones beside each other, as a carpet and its pile, are in one place.
    constexpr double kAway = 0.5;  // of the larger
    const model::Vector3 from = 0.5 * (touched.bounds.min + touched.bounds.max);
    const model::Vector3 to = 0.5 * (seen.bounds.min + seen.bounds.max);
    if (!(length(to - from) > kAway * std::max(a, b))) continue;
    context.report({.where = root[link.collisions.front()].geometry.site.name,
                    .message = fmt::format("the link's collisions and visuals share {:.0f} % of "
                                           "their boxes: their middles are {:.3g} m apart",
                                           100 * share, length(to - from)),
                    .subject = context.subject(link),
                    .related = {{root[link.visuals.front()].geometry.site.name, "what is seen"}}});
  }
}

Rule rule() {
  return {
      .name = "collision-beside-visual",
      .severity = Severity::kWarning,
      .summary = "a link's collisions are not where its visuals are",
      .why = "The link is touched where nothing is seen, and passes through what it is seen to "
             "hit. The box around all its collisions and that around all its visuals hardly "
             "overlap: an origin was left out of one of them, is that of another link, or a mesh "
             "has another origin.",
      .what_to_do = "Give both the same origin, or the mesh's. Suppress the finding where the "
                    "body is not drawn.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::collision_beside_visual
