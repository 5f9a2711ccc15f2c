// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A closed mesh cut in two by a plane, each half closed again by a cap.
//
// Vertices near the plane count as on it and stay where they are. What a half lacks then is edges that
// lead round and round in the plane, which a cap fills (mesh/repair/cap.h).
//
//   const Halves halves = cut(mesh, {.normal = {0, 0, 1}, .offset = 0.1});

#pragma once

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

struct Plane {
  Vector3 normal = {0, 0, 1};  ///< a unit vector
  double offset = 0;           ///< where dot(normal, p) is this, there is the plane
};

/// How far from the plane a vertex is on it, as a share of the mesh's diagonal: what rounding leaves
/// of coordinates that were computed in double.
inline constexpr double kOnPlane = 1e-12;

/// The same for those that were rounded to 32 bits.
inline constexpr double kOnPlane32 = 1e-6;

struct Halves {
  TriangleMesh below;  ///< where dot(normal, p) is less than the offset
  TriangleMesh above;
};

/// Corners in one place are welded. Triangles in the plane are replaced by the caps. A half that has
/// nothing is empty. Of an open mesh the halves are open where it is.
Halves cut(const TriangleMesh& mesh, const Plane& plane, double on_plane = kOnPlane);

}  // namespace rigor::mesh
