// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The smallest ball around points; of points in a plane, its great circle there is their smallest
// circle.
//
//   const Ball ball = enclosing_ball(hull.positions);

#pragma once

#include <vector>

#include <rigor/mesh/ball.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// Around every point exactly; its radius is within 1e-11 of the least. Of no point it is empty.
Ball enclosing_ball(const std::vector<Vector3>& points);

}  // namespace rigor::mesh
