// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Planes that a body may well be cut by, so that what is left is less concave.
//
//   for (const CutPlane& candidate : planes_to_try(mesh, 60)) rate(cut(mesh, candidate.plane));

#pragma once

#include <cstddef>
#include <vector>

#include <rigor/mesh/convex/plane_cut.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

struct CutPlane {
  Plane plane;
  /// Which share of the body's concave edges lies in it, by length and angle.
  double concave = 0;
};

/// Half of them through concave edges, along a face there or midway between both; the others across
/// the coordinate axes and the body's principal axes, evenly spread.
std::vector<CutPlane> planes_to_try(const TriangleMesh& mesh, std::size_t count);

}  // namespace rigor::mesh
