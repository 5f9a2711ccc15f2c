// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Primitives around points along an axis that is given, and which axes to give.
//
//   for (const Vector3& axis : axes_to_try(hull)) consider(cylinder_along(axis, hull.positions));

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <rigor/mesh/primitive/primitive_mesh.h>
#include <rigor/model/pose.h>

namespace rigor::mesh {

struct Placed {
  Primitive shape;
  model::Pose pose;  ///< X_MP
  double volume = 0;
};

/// Orthonormal and right-handed; the third is the axis.
using Basis = std::array<Vector3, 3>;

/// About a unit vector; of coordinate axes for a coordinate axis.
Basis basis_about(const Vector3& axis);

/// The one around the points with these directions.
Placed box_along(const Basis& directions, const std::vector<Vector3>& points);

/// With two faces across the axis, turned about it to be the smallest.
Placed box_about(const Vector3& axis, const std::vector<Vector3>& points);

Placed cylinder_along(const Vector3& axis, const std::vector<Vector3>& points);

/// Of the least radius along this axis, and of the least length for it.
Placed capsule_along(const Vector3& axis, const std::vector<Vector3>& points);

/// The coordinate axes are the first of `axes_to_try`.
inline constexpr std::size_t kCoordinateAxes = 3;

/// Unit vectors, the likeliest first; few for a hull of many points, so that all take a second or so.
std::vector<Vector3> axes_to_try(const TriangleMesh& hull);

}  // namespace rigor::mesh
