// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Moves positions that are near each other to one place.
//
//   moved = weld_within(mesh, 1e-6 * diagonal(bounds_of(mesh.positions)));

#pragma once

#include <cstdint>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// Each position goes to the nearest of those before it that stayed and lie within the distance;
/// otherwise it stays. Returns how many were moved. Triangles keep their corners and may become
/// degenerate.
std::uint64_t weld_within(TriangleMesh& mesh, double distance);

}  // namespace rigor::mesh
