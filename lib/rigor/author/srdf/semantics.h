// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What an SRDF (http://wiki.ros.org/srdf) says of a robot, found in the robot's structure: chains of moving
// joints, grippers at their ends, how it is tied to the world, a home state, and which links need no check
// against each other.
//
//   Semantics semantics = semantics_of(robot);
//   semantics.disabled = disabled_pairs(robot, self_collisions(robot, bodies, {}, turns));
//   write(srdf_text(semantics));

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/robot/collision/self_collisions.h>
#include <rigor/robot/robot.h>

namespace rigor::author {

/// A chain, or else a list of links and joints.
struct SemanticGroup {
  std::string name;
  std::string base_link = {}, tip_link = {};  ///< of a chain
  std::vector<std::string> links = {};
  std::vector<std::string> joints = {};
};

/// Positions of a group's joints, rad or m; none of those that follow others.
struct SemanticState {
  std::string name;
  std::string group;
  std::vector<std::pair<std::string, double>> positions;
};

struct EndEffector {
  std::string name;
  std::string parent_link;
  std::string group;
  std::string parent_group;
};

struct VirtualJoint {
  std::string name;
  std::string type;  ///< "fixed", "planar" or "floating"
  std::string parent_frame;
  std::string child_link;
};

/// A pair that is not checked, with the reason in the words of MoveIt's setup assistant: "Adjacent", "Default",
/// "Always", "Never"; "User" of what a person decided.
struct DisabledPair {
  std::string link1;
  std::string link2;
  std::string reason;
};

struct Semantics {
  std::string robot;
  std::vector<SemanticGroup> groups;
  std::vector<SemanticState> states;
  std::vector<EndEffector> end_effectors;
  std::optional<VirtualJoint> virtual_joint;
  std::vector<DisabledPair> disabled;
};

/// All but `disabled`.
///
/// A chain is a run of at least two moving joints without a branch that moves, from the link that carries its first
/// joint to the last link before a branch, or to the end of the longest line of fixed links behind its last joint.
/// Branches behind a chain are a gripper when the longest of them is at most half as long as the chain; so is a
/// whole robot in which all joints follow one. The virtual joint is planar where wheels (continuous joints that
/// carry nothing else that moves) are on the root, else fixed; a root named `world` has none. The
/// home state is `robot::rest_positions`.
Semantics semantics_of(const robot::Robot& robot);

/// Those that are not `kSometimes`, in their order.
std::vector<DisabledPair> disabled_pairs(const robot::Robot& robot,
                                         const std::vector<robot::LinkPair>& pairs);

/// Whether an assistant found the reason, so that it may be found anew; "User" and others are people's.
bool is_computed_reason(std::string_view reason);

}  // namespace rigor::author
