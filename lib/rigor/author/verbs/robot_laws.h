// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What verbs do to a robot, as functions of the robot alone: the laws that edited files are held against.
//
//   robot::Robot expected = restricted(edited.robot, subtree_of(edited.robot, hand));
//
// Private to the room.

#pragma once

#include <cstdint>
#include <vector>

#include <rigor/model/pose.h>
#include <rigor/robot/robot.h>

namespace rigor::author {

/// By body: those that hang on one, itself among them.
std::vector<bool> subtree_of(const robot::Robot& robot, std::uint32_t body);

/// The robot with those bodies only, the joints between them and the frames on them. A body that loses its carrier is a
/// root, its frame as it was.
robot::Robot restricted(const robot::Robot& robot, const std::vector<bool>& kept);

/// The body described in another frame N, given X_BN. Nothing moves: what it holds and carries is where it was. Of a root
/// X_MB goes along; a joint that carries it would have to be moved by who asks.
void describe_in(robot::Robot& robot, std::uint32_t body, const model::Pose& X_BN);

/// The joints on the way from a body up to its root, in this order.
std::vector<std::uint32_t> path_to_root(const robot::Robot& robot, std::uint32_t body);

}  // namespace rigor::author
