// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include <rigor/rules/rule.h>

namespace rigor::rules::closed_chain {

/// Links that joints connect, as a forest of sets (Tarjan's union-find).
class Sets {
 public:
  explicit Sets(std::size_t count) : up_(count) {
    std::iota(up_.begin(), up_.end(), std::size_t{0});
  }

  /// False when the two were connected already.
  bool join(std::size_t a, std::size_t b) {
    const std::size_t root_a = find(a);
    const std::size_t root_b = find(b);
    up_[root_a] = root_b;
    return root_a != root_b;
  }

 private:
  std::size_t find(std::size_t at) {
    while (up_[at] != at) at = up_[at] = up_[up_[at]];
    return at;
  }
  std::vector<std::size_t> up_;
};

void check(const model::Root& root, Context& context) {
  const std::size_t world = root.links.size();
  Sets sets(world + 1);
  for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
    const auto& ends = context.frames().ends({i});
    if (!ends.child || ends.parent == ends.child || (!ends.parent && !ends.parent_is_world))
      continue;
    const std::size_t parent = ends.parent_is_world ? world : ends.parent.value;
    if (sets.join(parent, ends.child.value) || !root.own(root.joints[i].site)) continue;
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
      .why = "SDF allows it and engines that work in maximal coordinates (ODE, Bullet) simulate "
             "it. DART and other engines of trees drop or cut such a joint, and URDF has no way to "
             "say it.",
      .what_to_do = "Nothing, if the loop is meant and the engine can do it.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::closed_chain
