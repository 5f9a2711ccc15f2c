// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/geometry/overlapping_links.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::links_overlap {

void check(const model::Root& root, Context& context) {
  if (root.links.size() < 2 || root.collisions.size() < 2) return;
  const robot::LinkOverlaps found = robot::lasting_overlaps(root, context.frames());
  if (found.empty()) return;
  const SelfColliding self_colliding(root, context);
  for (const auto& [top, pairs] : found) {
    if (!root.own(root[top].site)) continue;
    std::vector<robot::LinkOverlap> quiet;  // of the others links-collide-at-start speaks
    for (const robot::LinkOverlap& pair : pairs) {
      if (!self_collide(pair, self_colliding)) quiet.push_back(pair);
    }
    report_overlaps(root[top], quiet, "where the model begins", context);
  }
}

Rule rule() {
  return {
      .name = "links-overlap",
      .severity = Severity::kInfo,
      .summary = "links of a model that no joint connects overlap",
      .why = "Gazebo does not let the links of a model collide unless <self_collide> says so. "
             "MuJoCo and Drake do, but for parent and child: there the two push each other from "
             "the first step on. A motion planner calls the pose a collision. Boxes, balls, "
             "cylinders and the like are looked at, meshes are not; where zero is outside a "
             "joint's limits, the joint is taken at the nearest limit.",
      .what_to_do = "Make the collisions smaller, or move them apart; or exclude the pair where "
                    "the model is used: <exclude> in MJCF, <disable_collisions> in SRDF.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::links_overlap
