// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which shapes can roll: balls, cylinders and capsules about their own axis, meshes with a round outline.
//
//   if (const auto round = round_about(scene, shape, axis_W)) roll(round->radius);

#pragma once

#include <optional>

#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

/// What of a shape can roll about an axis.
struct RoundShape {
  double radius = 0;  ///< m
  double width = 0;   ///< m
  Vector3 middle_W;
  Vector3 axis_W;  ///< its own; zero for a ball
};

/// Nothing when it is not round about an axis that is roughly this one.
std::optional<RoundShape> round_about(const Scene& scene, const SceneShape& shape,
                                      const Vector3& axis_W);

}  // namespace rigor::simulate
