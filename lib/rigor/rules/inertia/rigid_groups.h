// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Links that fixed joints make one body. Simulators that keep fixed joints apart move them as one all
// the same, and authors write the mass of all in one of them.
//
//   RigidGroups groups(context);
//   if (groups.of(parent) == groups.of(child)) …

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <rigor/rules/context.h>
#include <rigor/text/disjoint_sets.h>

namespace rigor::rules {

class RigidGroups {
 public:
  explicit RigidGroups(const Context& context) {
    const model::Root& root = context.root();
    DisjointSets fixed(root.links.size());
    for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
      const auto& ends = context.frames().ends({i});
      if (root.joints[i].type != model::JointType::kFixed || !ends.parent || !ends.child) continue;
      fixed.join(ends.child.value, ends.parent.value);
    }
    for (std::uint32_t i = 0; i < root.links.size(); ++i) group_.push_back(fixed.find(i));
  }

  /// The index of the link that represents the group.
  std::uint32_t of(model::Id<model::Link> link) const { return group_[link.value]; }
  std::size_t size() const { return group_.size(); }

 private:
  std::vector<std::uint32_t> group_;
};

/// The links without mass by group, found when first asked for.
class LazyGroups {
 public:
  explicit LazyGroups(const Context& context) : context_(context) {}

  /// Those that are fixed to `link` and have no mass of their own.
  std::vector<const model::Link*> massless_beside(const model::Link& link) {
    const model::Root& root = context_.root();
    if (!groups_) fill();
    const auto index = static_cast<std::uint32_t>(&link - root.links.data());
    std::vector<const model::Link*> result;
    for (const std::uint32_t other : massless_[groups_->of({index})]) {
      if (other != index) result.push_back(&root.links[other]);
      if (result.size() == kMax) break;
    }
    return result;
  }

 private:
  // A token for a frame that had to have some mass.
  static constexpr double kToken = 1e-3;  // kg
  // Each link of a group may ask for all others of it.
  static constexpr std::size_t kMax = 64;

  void fill() {
    const model::Root& root = context_.root();
    groups_.emplace(context_);
    massless_.resize(root.links.size());
    for (std::uint32_t i = 0; i < root.links.size(); ++i) {
      const model::Inertial& inertial = root.links[i].inertial;
      if (inertial.mass.written && inertial.mass.value > kToken) continue;
      massless_[groups_->of({i})].push_back(i);
    }
  }

  const Context& context_;
  std::optional<RigidGroups> groups_;
  std::vector<std::vector<std::uint32_t>> massless_;
};

}  // namespace rigor::rules
