// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The masses on both sides of the joints that move: what is fixed together counts as one.
//
//   for (const JointMasses& joint : joint_masses(context)) say(joint.parent / joint.child);

#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <rigor/mass/resolve.h>
#include <rigor/rules/inertia/rigid_groups.h>
#include <rigor/rules/inertia/tensor.h>

namespace rigor::rules {

/// What does not move weighs more than anything.
inline constexpr double kImmovable = std::numeric_limits<double>::infinity();  // kg

struct JointMasses {
  model::Id<model::Joint> joint;
  std::uint32_t parent_group = 0;  ///< see RigidGroups; not of kImmovable
  std::uint32_t child_group = 0;
  double parent = 0;  ///< kg
  double child = 0;   ///< kg
};

/// Of joints whose links are known and have mass.
inline std::vector<JointMasses> joint_masses(const Context& context) {
  const model::Root& root = context.root();
  const auto moves = [](model::JointType type) { return type != model::JointType::kFixed; };
  std::vector<JointMasses> result;
  std::optional<RigidGroups> groups;
  std::vector<double> masses;
  const auto fill = [&] {
    groups.emplace(context);
    masses.assign(root.links.size(), 0);
    for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
      const auto& ends = context.frames().ends({i});
      if (moves(root.joints[i].type) || !ends.parent_is_world || !ends.child) continue;
      masses[groups->of(ends.child)] = kImmovable;
    }
    for (std::uint32_t i = 0; i < root.links.size(); ++i) {
      const bool still = !is_dynamic(root.links[i], context);
      masses[groups->of({i})] += still ? kImmovable : mass::resolve(root, {i}).mass;
    }
  };
  for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
    const auto& ends = context.frames().ends({i});
    if (!moves(root.joints[i].type) || !ends.child) continue;
    if (!ends.parent && !ends.parent_is_world) continue;
    if (!groups) fill();
    JointMasses masses_of{.joint = {i}, .child_group = groups->of(ends.child)};
    masses_of.child = masses[masses_of.child_group];
    if (ends.parent) masses_of.parent_group = groups->of(ends.parent);
    masses_of.parent = ends.parent_is_world ? kImmovable : masses[masses_of.parent_group];
    if (masses_of.parent > 0 && masses_of.child > 0) result.push_back(masses_of);
  }
  return result;
}

}  // namespace rigor::rules
