// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>
#include <unordered_map>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/inertia/joint_masses.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::light_link_between_heavy {

// A link that is a hundredth of its subtree: twice what solvers take well.
constexpr double kMax = 100;

void check(const model::Root& root, Context& context) {
  const std::vector<JointMasses> all = joint_masses(context);
  std::unordered_map<std::uint32_t, const JointMasses*> above;  // by the group that is the child
  for (const JointMasses& masses : all) {
    if (masses.child == kImmovable || masses.parent < kMax * masses.child) continue;
    above.emplace(masses.child_group, &masses);
  }
  if (above.empty()) return;
  std::unordered_map<std::uint32_t, const JointMasses*> heaviest;  // by the light group
  for (const JointMasses& masses : all) {
    if (masses.parent == kImmovable || masses.child == kImmovable) continue;
    if (masses.child < kMax * masses.parent || !above.contains(masses.parent_group)) continue;
    const JointMasses*& known = heaviest[masses.parent_group];
    if (known == nullptr || known->child < masses.child) known = &masses;
  }
  for (const JointMasses& below : all) {
    const auto light = heaviest.find(below.parent_group);
    if (light == heaviest.end() || light->second != &below) continue;
    const model::Joint& joint = root[below.joint];
    if (!root.own(joint.site)) continue;
    const JointMasses& over = *above.at(below.parent_group);
    context.report({.where = joint.site.name,
                    .message = fmt::format(
                        "{:.4g} kg are carried by a link {:.3g} times lighter ({:.4g} kg), which "
                        "another joint connects to {}: the joints may separate or oscillate",
                        below.child, below.child / below.parent, below.parent,
                        over.parent == kImmovable ? "what does not move"
                                                  : fmt::format("{:.4g} kg", over.parent)),
                    .subject = context.subject(joint),
                    .related = {{root[over.joint].site.name, "the other joint"}}});
  }
}

Rule rule() {
  return {
      .name = "light-link-between-heavy",
      .severity = Severity::kWarning,
      .summary = "a light link between heavy ones",
      .why = "All the weight goes through the light link, and iterative solvers, which Gazebo's "
             "engines use by default, need about as many iterations as the ratio of the masses: "
             "the joints are pulled apart, or the chain swings and shakes.",
      .what_to_do = "Give the light link more mass, or make the two joints one (a universal or "
                    "ball joint). Masses within a factor of 50 are safe.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::light_link_between_heavy
