// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/geometry/overlapping_links.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::links_collide_at_start {

void check(const model::Root& root, Context& context) {
  if (root.links.size() < 2 || root.collisions.size() < 2) return;
  const SelfColliding self_colliding(root, context);
  // Nearly no file says it, so that the others need not be measured.
  if (!self_colliding.any()) return;
  for (const auto& [top, pairs] : robot::lasting_overlaps(root, context.frames())) {
    if (!root.own(root[top].site)) continue;
    std::vector<robot::LinkOverlap> pushed;
    for (const robot::LinkOverlap& pair : pairs) {
      if (self_collide(pair, self_colliding)) pushed.push_back(pair);
    }
    report_overlaps(root[top], pushed, "at the start and may collide (self_collide)", context);
  }
}

Rule rule() {
  return {
      .name = "links-collide-at-start",
      .severity = Severity::kWarning,
      .summary = "links of a model that may collide with itself overlap",
      .why = "Two that overlap at the start are pushed apart at the first step: the model jumps, "
             "or does not settle as long as a joint keeps them there. With <self_collide> the "
             "links of a model collide, except those that a joint connects. Primitive shapes are "
             "checked, meshes are skipped.",
      .what_to_do =
          "Make the collisions smaller, or move them apart; or take <self_collide> from the links.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::links_collide_at_start
