// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Normals of a mesh's corners, made anew: flat, or smooth but for edges that are sharper than some
// angle.
//
//   mesh = recomputed_normals(std::move(mesh), 0.5);   // about 30°
//   mesh = recomputed_normals(std::move(mesh), kFlat);

#pragma once

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// A crease angle at which each triangle has its own normal. One of pi makes all edges smooth.
inline constexpr double kFlat = 0;

/// Gives each corner the mean normal of the triangles around its place that can be reached without
/// crossing a sharp edge, weighted by the angle that each has there (G. Thürmer, C. A. Wüthrich,
/// "Computing Vertex Normals from Polygonal Facets", Journal of Graphics Tools 3(1), 1998): how a
/// surface is cut into triangles makes no difference.
///
/// An edge is sharp when the normals at both sides differ by more than `crease_angle` (radians),
/// and when not exactly two triangles meet there. Positions of equal coordinates are one place.
/// Corners of triangles without area get no normal.
TriangleMesh recomputed_normals(TriangleMesh mesh, double crease_angle);

/// The direction with length 1; zeros when it has none. 32-bit numbers of length 1 but for their
/// rounding stay as they are, so that nothing drifts from one file to the next.
Corners::Normal normal_along(const Vector3& direction);

/// Perpendicular to a triangle; zeros when it has no area.
Corners::Normal normal_of(const Facet& f);

/// The same direction in doubles.
Vector3 as_vector(const Corners::Normal& normal);

}  // namespace rigor::mesh
