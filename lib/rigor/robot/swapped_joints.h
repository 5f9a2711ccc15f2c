// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which joints of a tree hang the other way round. A body of URDF has one parent; SDF's joints may lead
// to one from two sides and still be a tree: then some of them must be turned, parent and child swapped
// and the axis negated, which is exact. Private to the room.
//
//   std::vector<Edge::Direction> directions = edge_directions(edges, bodies, world);
//   if (directions[i] == Edge::Direction::kTurned) std::swap(joint.parent, joint.child);

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <rigor/model/model.h>
#include <rigor/robot/robot.h>

namespace rigor::robot {

/// A joint between two bodies.
struct Edge {
  enum class Direction : std::uint8_t {
    kAsWritten,
    kTurned,
    kLeftOut,  ///< it closes a loop, or would have to be turned and cannot be
  };
  std::uint32_t parent = 0, child = 0;
  bool can_turn = true;
};

/// Of joints in file order, the first keeps its direction where either may. `world` is the body that
/// nothing can carry.
std::vector<Edge::Direction> edge_directions(const std::vector<Edge>& edges, std::size_t bodies,
                                             std::uint32_t world = kNoIndex);

/// Of several axes in a row the order would turn, too.
bool can_turn(model::JointType type);

}  // namespace rigor::robot
