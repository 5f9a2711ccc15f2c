// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>
#include <vector>

#include <rigor/rules/rule.h>

namespace rigor::rules::loose_link {

/// Whether a joint of the model holds two links together, not only one to the world.
bool connects_links(const model::Model& model, Context& context) {
  for (const auto id : model.joints) {
    const auto& ends = context.frames().ends(id);
    if (ends.parent && ends.child && ends.parent != ends.child) return true;
  }
  return false;
}

void check(const model::Root& root, Context& context) {
  std::vector<bool> connected(root.links.size(), false);
  for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
    const auto& ends = context.frames().ends({i});
    // Where an end does not resolve, it is unknown which link is loose.
    if (!ends.child || (!ends.parent && !ends.parent_is_world)) return;
    connected[ends.child.value] = true;
    if (ends.parent) connected[ends.parent.value] = true;
  }
  for (const model::Include& include : root.includes) {
    if (include.model && !include.followed) return;
  }
  for (const model::Model& model : root.models) {
    // Links that no joint connects to another are a heap of parts, and meant as that.
    if (!root.own(model.site) || !connects_links(model, context)) continue;
    for (const auto id : model.links) {
      const model::Link& link = root[id];
      if (connected[id.value] || link.kinematic.value || is_static(root, link.model)) continue;
      context.report({.where = link.site.name,
                      .message = "no joint holds the link '" + link.name.value +
                                 "': it is a body of its own and falls off",
                      .subject = context.subject(link)});
    }
  }
}

Rule rule() {
  return {
      .name = "loose-link",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "a link of a model with joints has none",
      .why = "The simulator lets it move by itself: it falls away from the rest of the model when "
             "the simulation starts.",
      .what_to_do = "Connect it by a joint, fixed if it shall keep its place.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::loose_link
