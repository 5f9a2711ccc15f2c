// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>
#include <vector>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/misspelt.h>

namespace rigor::rules::collision_missing {

void report_link(const model::Link& link, Context& context) {
  if (misspelt_child(link.site, "collision", context)) return;  // unknown-element
  context.report({.where = link.site.name,
                  .message = "the link '" + link.name.value +
                             "' can be seen but not touched: it has a visual and no collision",
                  .subject = context.subject(link)});
}

void check(const model::Link& link, Context& context) {
  if (link.visuals.empty() || !link.collisions.empty() || context.is_urdf()) return;
  if (link.kinematic.value || is_static(context.root(), link.model)) return;
  report_link(link, context);
}

/// A URDF without any collision is for the eye only, and a part that is fixed to another needs none.
void check_robot(const model::Model& robot, Context& context) {
  const model::Root& root = context.root();
  if (!context.is_urdf() || root.collisions.empty()) return;
  std::vector<bool> fixed(root.links.size(), false);
  for (const auto id : robot.joints) {
    const auto child = context.frames().ends(id).child;
    if (child && root[id].type == model::JointType::kFixed) fixed[child.value] = true;
  }
  for (const auto id : robot.links) {
    const model::Link& link = root[id];
    if (!link.visuals.empty() && link.collisions.empty() && !fixed[id.value])
      report_link(link, context);
  }
}

Rule rule() {
  return {
      .name = "collision-missing",
      .severity = Severity::kInfo,
      .summary = "a link that moves has a visual but no collision",
      .why = "It falls through the ground and other bodies pass through it. That is often meant, "
             "for a small part that is fixed to another; in a URDF those are not told of, nor "
             "robots without any collision.",
      .what_to_do = "Add a collision, best a simple shape about the visual.",
      .checks = {on<model::Link>(check), on<model::Model>(check_robot)},
  };
}

}  // namespace rigor::rules::collision_missing
