// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Chains and grippers in a robot's tree of joints. Private to the folder; what they are: semantics.h.
//
//   for (const FoundGroup& found : find_groups(robot).groups) …

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <rigor/author/srdf/semantics.h>

namespace rigor::author {

struct FoundGroup {
  SemanticGroup group;
  std::vector<std::uint32_t> joints;  ///< that move, in the robot's order along the tree
  std::string parent_link = {};       ///< of a gripper: the last link of its chain
  std::string parent_group = {};      ///< of a gripper: the chain's
};

struct FoundGroups {
  std::vector<FoundGroup> groups;
  std::uint32_t root = robot::kNoIndex;  ///< the first body that no joint carries
  bool has_wheels = false;
};

FoundGroups find_groups(const robot::Robot& robot);

}  // namespace rigor::author
