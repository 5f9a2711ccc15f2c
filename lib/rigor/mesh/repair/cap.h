// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Triangles that close holes whose edges lie in a plane, with islands and holes in them.
//
//   const std::vector<Triangle> cap = cap_of(edges, mesh.positions, {0, 0, 1});

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// From one position to another.
using DirectedEdge = std::array<std::uint32_t, 2>;

/// Triangles with no vertices but those of the edges, which have each edge once and face the normal, a
/// unit vector, when the region is on the edges' left. Edges that do not lead back to where they began
/// are left as they are. Where edges cross or come too close, triangles may fold over; what they
/// close, and the volume they enclose, stays right.
std::vector<Triangle> cap_of(const std::vector<DirectedEdge>& edges,
                             const std::vector<Vector3>& positions, const Vector3& normal);

}  // namespace rigor::mesh
