// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Wheels of an assembled model, and which of them are on one axle.
//
//   for (const Axle& axle : axles(wheels(root, frames, robot))) compare(axle.a, axle.b);
//
// A wheel is the child of a joint that turns on and on (no limits, or more than ten turns), with a shape
// that is round about the joint's axis and centered on it: a cylinder, a ball, or a mesh whose box is square.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <rigor/model/frames.h>
#include <rigor/model/model.h>
#include <rigor/robot/assembled/assembled.h>

namespace rigor::robot {

struct Wheel {
  std::uint32_t link = 0;
  std::uint32_t joint = 0;
  model::Vector3 axis_W;    ///< unit vector, of the joint
  model::Vector3 center_W;  ///< m, of the shape
  /// m; nothing when no collision, or no visual, is round.
  std::optional<double> collision_radius;
  std::optional<double> visual_radius;
  std::uint32_t shape = 0;  ///< the one that rolls: of the collision, else of the visual

  double radius() const { return collision_radius ? *collision_radius : visual_radius.value_or(0); }
};

std::vector<Wheel> wheels(const model::Root& root, const model::Frames& frames,
                          const Assembled& robot);

/// Places in the list of wheels: their axes are parallel and level, one is beside the other along them, and
/// neither carries the other.
struct Axle {
  std::size_t a = 0;
  std::size_t b = 0;
};

std::vector<Axle> axles(const std::vector<Wheel>& wheels, const Assembled& robot);

/// The radius of a shape about an axis through its middle, m; nothing when it is not round about it.
std::optional<double> radius_about(const AssembledShape& shape, const model::Shape& of,
                                   const model::Vector3& axis_W);

/// Whether a joint may turn on and on.
bool turns_on_and_on(const model::Joint& joint);

}  // namespace rigor::robot
