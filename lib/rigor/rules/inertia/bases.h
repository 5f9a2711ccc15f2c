// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Links that hold what moves on them: their mass and moments may be made up.

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <rigor/rules/context.h>

namespace rigor::rules {

/// A base that holds what moves on it is made heavy on purpose.
class LazyBases {
 public:
  explicit LazyBases(const Context& context) : context_(context) {}

  bool has(const model::Link& link) {
    const model::Root& root = context_.root();
    if (roles_.empty()) fill();
    const Roles& roles = roles_[static_cast<std::size_t>(&link - root.links.data())];
    return roles.fixed_to_world || (roles.parent && !roles.child);
  }

 private:
  struct Roles {
    bool parent = false;
    bool child = false;
    bool fixed_to_world = false;
  };

  void fill() {
    const model::Root& root = context_.root();
    roles_.resize(root.links.size());
    for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
      const auto& ends = context_.frames().ends({i});
      if (ends.parent) roles_[ends.parent.value].parent = true;
      if (!ends.child) continue;
      roles_[ends.child.value].child = true;
      if (ends.parent_is_world) roles_[ends.child.value].fixed_to_world = true;
    }
  }

  const Context& context_;
  std::vector<Roles> roles_;
};

}  // namespace rigor::rules
