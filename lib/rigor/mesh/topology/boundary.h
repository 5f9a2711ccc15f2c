// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where a mesh is open: its edges of one triangle, and the loops that they form.
//
//   Boundary boundary = boundary_of(mesh, welded, rings.bad_edges);
//   if (boundary.loops == 1 && boundary.longest_edges <= 4) fill();

#pragma once

#include <cstdint>
#include <vector>

#include <rigor/mesh/topology/rings.h>
#include <rigor/mesh/topology/weld.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

struct Boundary {
  std::uint64_t loops = 0;          ///< boundary edges that hang together; holes that touch are one
  std::uint64_t longest_edges = 0;  ///< number of edges of the loop of the greatest length
  double longest_length = 0;        ///< in the mesh's unit
  double total_length = 0;
};

/// Other bad edges are passed over.
Boundary boundary_of(const TriangleMesh& mesh, const Weld& welded,
                     const std::vector<BadEdge>& edges);

}  // namespace rigor::mesh
