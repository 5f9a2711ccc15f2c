// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Triangles that fill a loop of edges in space.
//
// Of all ways to fill a loop of up to `kMaxBestEdges` the best is found: with the fewest edges that
// the mesh has already and the fewest slivers, then the least bent against what is around it, then of
// the least size. (G. Barequet, M. Sharir, "Filling gaps in the boundary of a polyhedron", 1995;
// P. Liepa, "Filling holes in meshes", 2003.) The time of that grows with the cube of the edges; ears
// are cut off longer loops, seen in their plane.
//
//   for (const Triangle& t : filling(work, hole)) work.add(t, hole.faces[0]);

#pragma once

#include <cstddef>
#include <vector>

#include <rigor/mesh/repair/workpiece.h>
#include <rigor/mesh/topology/holes.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// 160,000 triangles are examined for it: some hundredths of a second.
inline constexpr std::size_t kMaxBestEdges = 100;

/// The triangles of the best filling; there are two fewer than edges.
std::vector<Triangle> best_filling(const Workpiece& work, const Hole& hole);

/// Nothing when the loop crosses itself in its plane.
std::vector<Triangle> ear_filling(const Workpiece& work, const Hole& hole);

}  // namespace rigor::mesh
