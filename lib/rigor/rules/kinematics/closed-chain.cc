// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>

#include <rigor/rules/rule.h>
#include <rigor/text/disjoint_sets.h>

namespace rigor::rules::closed_chain {

void check(const model::Root& root, Context& context) {
  const auto world = static_cast<std::uint32_t>(root.links.size());
  DisjointSets connected(root.links.size() + 1);  // the last is the world
  for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
    if (root.joints[i].type == model::JointType::kGearbox) continue;  // it couples two joints
    const auto& ends = context.frames().ends({i});
    if (!ends.child || ends.parent == ends.child || (!ends.parent && !ends.parent_is_world))
      continue;
    const std::uint32_t parent = ends.parent_is_world ? world : ends.parent.value;
    if (connected.join(parent, ends.child.value) || !root.own(root.joints[i].site)) continue;
    const model::Joint& joint = root.joints[i];
    context.report({.where = joint.site.name,
                    .message = "the joint '" + joint.name.value + "' closes a chain: '" +
                               joint.parent.value + "' and '" + joint.child.value +
                               "' are already connected",
                    .subject = context.subject(joint)});
  }
}

Rule rule() {
  return {
      .name = "closed-chain",
      .severity = Severity::kInfo,
      .formats = Formats::kSdf,
      .summary = "a joint closes a kinematic chain",
      .why =
          "SDF allows it and engines that work in maximal coordinates (ODE, Bullet) simulate it. "
          "DART and other engines for trees drop or cut such a joint, and URDF cannot express it.",
      .what_to_do = "Nothing, if the loop is meant and the engine can do it.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::closed_chain
