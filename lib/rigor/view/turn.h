// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Rotations that bring axes where they are wanted. Private to the room.

#pragma once

#include <rigor/model/pose.h>

namespace rigor::view {

/// Brings z to a direction, which has a length, by the shortest way; half a turn about x where that is -z.
model::Quaternion turn_from_z(const model::Vector3& direction);

}  // namespace rigor::view
