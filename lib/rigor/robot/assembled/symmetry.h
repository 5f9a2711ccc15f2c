// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The plane that a robot is its own mirror image in, as far as its parts in pairs say so.
//
//   if (const auto plane = symmetry_plane(robot, pairs)) mirrored(*plane, p_W);

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <rigor/model/pose.h>
#include <rigor/robot/assembled/assembled.h>
#include <rigor/robot/assembled/twins.h>

namespace rigor::robot {

/// A plane normal to an axis of W.
struct MirrorPlane {
  std::size_t axis = 1;   ///< 0, 1 or 2: x, y or z
  double at = 0;          ///< m, along that axis
  std::size_t pairs = 0;  ///< whose frames are mirrored in it
  std::size_t others = 0;
};

/// The plane that most of these pairs of links are mirrored in, more than half of them and at least two;
/// nothing when there is none. All of one model.
std::optional<MirrorPlane> symmetry_plane(const Assembled& robot, const std::vector<Twins>& pairs);

/// A point's mirror image.
model::Vector3 mirrored(const MirrorPlane& plane, model::Vector3 p_W);

/// Whether one point is the mirror image of the other, to a share of the robot's size.
bool are_mirrored(const MirrorPlane& plane, const model::Vector3& p_W, const model::Vector3& q_W);

}  // namespace rigor::robot
