// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/inertia/automatic.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::automatic_inertia_without_collision {

void check(const model::Link& link, Context& context) {
  if (!is_computed(link, context) || !link.collisions.empty()) return;
  context.report({.where = link.inertial.automatic.span,
                  .message = "the inertia is to be computed from the link's collisions, and it has "
                             "none",
                  .subject = context.subject(link)});
}

Rule rule() {
  return {
      .name = "automatic-inertia-without-collision",
      .severity = Severity::kError,
      .formats = Formats::kSdf,
      .summary = "an automatic inertial has no collision to be computed from",
      .why = "libsdformat 14 and later refuse the file for it; visuals do not count. Older ones do "
             "not know auto=\"true\", and take 1 kg.",
      .what_to_do = "Give the link a collision, or write mass and tensor: `rigor inertia MODEL "
                    "--write` computes them from the visuals too.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::automatic_inertia_without_collision
