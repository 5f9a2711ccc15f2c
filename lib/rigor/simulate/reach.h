// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How far shapes reach in a direction at the start of a run, and where they would stand on level
// ground.
//
//   const double lowest = -reach(scene, shape, {0, 0, -1});
//   for (const Vector3& point : low_points(scene, shape, lowest + 0.002)) stand(point);

#pragma once

#include <vector>

#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

/// X_WS at the start.
Pose start_pose(const Scene& scene, const SceneShape& shape);

/// The largest p · direction of the shape's points p in W; infinite for half spaces and height grids.
double reach(const Scene& scene, const SceneShape& shape, const Vector3& direction_W);

/// Corners, vertices and lowest points of round shapes that are not above `height`: their convex hull
/// is where the shape stands. A circle that lies flat has eight. None of half spaces and grids.
std::vector<Vector3> low_points(const Scene& scene, const SceneShape& shape, double height);

/// The lowest points at the start, m, found once for a scene. Half spaces and height grids are minus
/// infinity, but for a model, which they do not count for; what has no shape is infinity.
struct LowestPoints {
  explicit LowestPoints(const Scene& scene);

  std::vector<double> of_shape;
  std::vector<double> of_body;
  std::vector<double> of_model;
};

/// The lowest point of a model's shapes at the start, m; infinity when it has none.
double lowest_of_model(const Scene& scene, std::uint32_t model);

}  // namespace rigor::simulate
