// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Closed loops of joints: none of one moves while the others are held. For sources of this room.
//
//   const std::vector<std::uint32_t> cycles = joint_cycles(scene);
//   if (cycles[a] == cycles[b] && cycles[a] != kWorld) move_together(a, b);

#pragma once

#include <cstdint>
#include <vector>

#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

/// Of each joint a number that it shares with the joints of its loop, and of loops that share a joint with it; kWorld of
/// one that is in none. What two joints hold to the world is a loop, too.
std::vector<std::uint32_t> joint_cycles(const Scene& scene);

}  // namespace rigor::simulate
