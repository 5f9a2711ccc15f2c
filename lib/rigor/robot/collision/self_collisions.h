// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which links of a robot touch each other as its joints move: the matrix by which a motion planner leaves out
// pairs that it need not check. The kinds are those of MoveIt's setup assistant, found in its order
// (moveit_setup_assistant, compute_default_collisions.cpp):
//
//   adjacent   a joint connects them, or joints do with only links without a collision between them
//   default    they touch where all joints are at rest (`rest_positions`)
//   always     they touch at 95 % of the first 200 samples, or more
//   never      they touch at no sample
//
// A sample is a position of all joints, uniform within their limits, joints that follow others where their
// leaders put them. Only links with a collision have pairs. A pair with a link of which a shape is not known is
// never `never`: what was not checked stays checked.
//
//   const SelfCollisions found = self_collisions(robot, bodies, {.samples = 10'000}, turns);
//   for (const LinkPair& pair : found.pairs) …

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <rigor/robot/collision/collision_bodies.h>
#include <rigor/robot/robot.h>
#include <rigor/text/turns.h>

namespace rigor::robot {

enum class PairKind : std::uint8_t { kAdjacent, kDefault, kAlways, kNever, kSometimes };

struct LinkPair {
  std::uint32_t a = 0, b = 0;  ///< bodies, a before b
  PairKind kind = PairKind::kSometimes;
};

struct SampleOptions {
  std::size_t samples = 10'000;
  std::uint64_t seed = 1;
};

/// Links with a collision: two million pairs. Humanoids have a hundred.
inline constexpr std::size_t kMaxCollisionLinks = 2000;

/// None of a robot with more links than that, and `too_many_links` then.
struct SelfCollisions {
  /// Of every two bodies with a collision, in the order of the bodies.
  std::vector<LinkPair> pairs;
  bool too_many_links = false;
};

/// The same for any number of turns.
SelfCollisions self_collisions(const Robot& robot, const CollisionBodies& bodies,
                               const SampleOptions& options, Turns& turns);

/// Every two bodies with a collision that are adjacent, in the order of the bodies: needs no shape.
std::vector<LinkPair> adjacent_pairs(const Robot& robot,
                                     const std::vector<bool>& bodies_with_shape);

/// Every axis at zero, or at the middle of its limits when zero is outside of them (at the nearer one when the
/// other is infinite); what follows another where its leader puts it. rad or m.
Positions rest_positions(const Robot& robot);

}  // namespace rigor::robot
