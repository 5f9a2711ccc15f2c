// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What rules on shapes say of robot/placed_collisions.h without its room's name.

#pragma once

#include <rigor/robot/placed_collisions.h>

namespace rigor::rules {

using robot::for_near_pairs;
using robot::placed_collisions;
using robot::PlacedCollision;
using robot::sizes_are_written;
using robot::top_models;

}  // namespace rigor::rules
