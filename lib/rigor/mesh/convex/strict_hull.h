// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A hull that is convex to the last digits. Qhull gives facets some width where points are nearly in a
// plane, and cuts them into triangles some of which have no direction to speak of: among corners of
// real meshes' pieces, some stood out of a face by 1e-8 of the size, and one by 5e-4.
//
//   TriangleMesh hull = made_strict(std::move(*convex_hull(points)));

#pragma once

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// How far a corner may be above a face, as a share of the hull's diagonal.
inline constexpr double kConvex = 1e-10;

/// How far a corner that is left out may lie outside of what remains: the rounding of 32-bit
/// coordinates.
inline constexpr double kLeftOut = 1e-7;

/// Leaves out corners that matter least where the hull is not convex to within `kConvex`, as long as
/// each matters less than `kLeftOut`, and a second's work is not passed.
TriangleMesh made_strict(TriangleMesh hull);

}  // namespace rigor::mesh
