// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What touches what, and how slippery it is. Private to the room.
//
// Two geoms collide when a bit of the one's `contype` is in the other's `conaffinity`, or the reverse. Bit 0
// is the ground's and that of everything else that a scene adds; each model has a bit of its own, which
// its own geoms do not accept, and those of links that may collide with their own model have bit 30 in both.
//
// Friction: MuJoCo takes the larger coefficient of two geoms, Gazebo the smaller; so a geom whose friction is
// written has `priority`, and its own coefficient holds against the ground.

#pragma once

#include <cstdint>

#include <rigor/convert/mjcf/draft.h>

namespace rigor::convert {

struct MjcfContactBits {
  std::uint32_t type = 1;
  std::uint32_t affinity = 1;
  bool operator==(const MjcfContactBits&) const = default;
};

/// Of links of the first model that do not collide with each other: what the class `collision` has.
inline constexpr MjcfContactBits kMjcfOneModel{2, 1};

/// Bits, friction and priority of a collision.
void set_contact(MjcfDraft& draft, std::uint32_t body, const model::Collision& collision,
                 MjcfElement& geom);

}  // namespace rigor::convert
