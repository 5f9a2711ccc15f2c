// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether a closed mesh bounds a convex body.
//
//   if (is_convex(mesh, volume)) engines_take_it_as_it_is();

#pragma once

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// Volume that a convex mesh may lack of its hull's, as a share: what rounding of 32-bit coordinates
/// costs a body of ordinary thickness.
inline constexpr double kConvexSlack = 1e-5;

/// `volume` is what the mesh encloses, positive; the mesh is closed. Triangles spread over the mesh
/// are tried first: most meshes have a vertex above one of them. Only what passes gets a hull, by
/// its own triangles (flip_hull.h), or else by its points.
bool is_convex(const TriangleMesh& mesh, double volume);

}  // namespace rigor::mesh
