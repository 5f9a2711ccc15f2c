// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include <rigor/rules/inertia/automatic.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::automatic_inertia_density_default {

void check(const model::Link& link, Context& context) {
  const model::Inertial& inertial = link.inertial;
  if (!is_computed(link, context) || inertial.mass.written || inertial.density.written) return;
  const model::Root& root = context.root();
  const auto without = std::find_if(link.collisions.begin(), link.collisions.end(),
                                    [&root](const auto id) { return !root[id].density.written; });
  if (without == link.collisions.end()) return;
  context.report({.where = inertial.automatic.span,
                  .message = "no density is given for the collision '" + root[*without].name.value +
                             "': it is taken to be water, 1000 kg/m³",
                  .subject = context.subject(link),
                  .related = {{root[*without].site.name, "this collision"}}});
}

Rule rule() {
  return {
      .name = "automatic-inertia-density-default",
      .severity = Severity::kInfo,
      .formats = Formats::kSdf,
      .summary = "an automatic inertial is computed with the density of water",
      .why = "Without <density> in the inertial or in the collision libsdformat takes 1000 kg/m³. "
             "Steel is eight times as heavy, a printed part lighter.",
      .what_to_do = "Write <density> in the <inertial>, in kg/m³; from libsdformat 15.2 on, <mass> "
                    "does as well.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::automatic_inertia_density_default
