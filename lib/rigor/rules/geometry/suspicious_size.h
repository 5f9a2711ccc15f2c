// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which shapes are so large that their sizes are likely to be in another unit than meters.

#pragma once

#include <algorithm>
#include <optional>

#include <rigor/mass/convex.h>
#include <rigor/robot/placed_collisions.h>

namespace rigor::rules {

// m. In 2,000 real model files one shape that may move is larger, a ball in a test.
inline constexpr double kLargeShape = 100;

/// The largest extent (m) of a shape with a closed form, where that is too much for what moves.
inline std::optional<double> suspicious_size(const model::Shape& shape) {
  const auto convex = mass::ConvexShape::of(shape, {});
  if (!convex || !robot::sizes_are_written(shape)) return std::nullopt;
  const mesh::Bounds box = convex->bounds();
  const model::Vector3 size = box.max - box.min;
  const double largest = std::max({size.x, size.y, size.z});
  return largest > kLargeShape ? std::optional(largest) : std::nullopt;
}

}  // namespace rigor::rules
