// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The convex hull of points, by qhull (C. B. Barber, D. P. Dobkin, H. Huhdanpaa, "The Quickhull
// Algorithm for Convex Hulls", ACM TOMS 22(4), 1996).
//
//   std::optional<TriangleMesh> hull = convex_hull(mesh.positions);

#pragma once

#include <optional>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// Closed, wound outward, with only the points that are corners of it. Nothing when the points lie in
/// a plane, on a line or in one place.
std::optional<TriangleMesh> convex_hull(const std::vector<Vector3>& points);

}  // namespace rigor::mesh
