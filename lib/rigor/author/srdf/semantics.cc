// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/srdf/semantics.h>

#include <rigor/author/srdf/group_finder.h>

namespace rigor::author {
namespace {

constexpr const char* kHome = "home";

std::string_view reason_of(robot::PairKind kind) {
  switch (kind) {
    case robot::PairKind::kAdjacent: return "Adjacent";
    case robot::PairKind::kDefault: return "Default";
    case robot::PairKind::kAlways: return "Always";
    case robot::PairKind::kNever: return "Never";
    case robot::PairKind::kSometimes: return {};
  }
  return {};
}

SemanticState home_state(const robot::Robot& robot, const FoundGroup& found,
                         const robot::Positions& rest) {
  SemanticState state{kHome, found.group.name, {}};
  for (const std::uint32_t j : found.joints) {
    const robot::Joint& joint = robot.joints[j];
    // SRDF has a list of values for joints with several axes, in an order that MoveIt alone defines.
    if (joint.axes.size() != 1 || joint.axes[0].follow) continue;
    state.positions.emplace_back(joint.name, rest[j][0]);
  }
  return state;
}

std::optional<VirtualJoint> virtual_joint_of(const robot::Robot& robot, const FoundGroups& found) {
  if (found.root == robot::kNoIndex || robot.bodies[found.root].name == robot::kWorldBody)
    return std::nullopt;
  return VirtualJoint{"virtual_joint", found.has_wheels ? "planar" : "fixed", robot::kWorldBody,
                      robot.bodies[found.root].name};
}

}  // namespace

Semantics semantics_of(const robot::Robot& robot) {
  const FoundGroups found = find_groups(robot);
  const robot::Positions rest = rest_positions(robot);
  Semantics semantics{.robot = robot.name};
  for (const FoundGroup& group : found.groups) {
    semantics.groups.push_back(group.group);
    SemanticState state = home_state(robot, group, rest);
    if (!state.positions.empty()) semantics.states.push_back(std::move(state));
    if (group.parent_group.empty()) continue;
    semantics.end_effectors.push_back(
        {group.group.name, group.parent_link, group.group.name, group.parent_group});
  }
  semantics.virtual_joint = virtual_joint_of(robot, found);
  return semantics;
}

std::vector<DisabledPair> disabled_pairs(const robot::Robot& robot,
                                         const std::vector<robot::LinkPair>& pairs) {
  std::vector<DisabledPair> disabled;
  for (const robot::LinkPair& pair : pairs) {
    const std::string_view reason = reason_of(pair.kind);
    if (reason.empty()) continue;
    disabled.push_back({robot.bodies[pair.a].name, robot.bodies[pair.b].name, std::string(reason)});
  }
  return disabled;
}

bool is_computed_reason(std::string_view reason) {
  return reason == "Adjacent" || reason == "Default" || reason == "Always" || reason == "Never";
}

}  // namespace rigor::author
