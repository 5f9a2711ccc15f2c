// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which joints of a tree hang the other way round. A body of URDF has one parent; SDF's joints may lead
// to one from two sides and still be a tree: then some of them must be turned, parent and child swapped
// and the axis negated, which is exact. Private to the room.
//
//   std::vector<Limb::Hang> hangs = hang_limbs(limbs, bodies, world);
//   if (hangs[i] == Limb::Hang::kTurned) std::swap(joint.parent, joint.child);

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <rigor/convert/robot.h>
#include <rigor/model/model.h>

namespace rigor::convert {

/// A joint between two bodies.
struct Limb {
  enum class Hang : std::uint8_t {
    kAsWritten,
    kTurned,
    kLeftOut,  ///< it closes a loop, or would have to be turned and cannot be
  };
  std::uint32_t parent = 0, child = 0;
  bool can_turn = true;
};

/// Of joints in file order, the first keeps its direction where either may. `world` is the body that
/// nothing can carry.
std::vector<Limb::Hang> hang_limbs(const std::vector<Limb>& limbs, std::size_t bodies,
                                   std::uint32_t world = kNoIndex);

/// Of several axes in a row the order would turn, too.
bool can_turn(model::JointType type);

}  // namespace rigor::convert
