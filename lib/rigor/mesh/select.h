// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Some of a mesh's triangles, or all turned over, with all that their corners carry.
//
//   TriangleMesh kept = selected(std::move(mesh), faces);  // in this order
//   turn_over(mesh, 3);

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// The positions that triangles use, each once, in their order.
std::vector<Vector3> used_positions(const TriangleMesh& mesh);

/// A mesh of these triangles, as one part, with the positions that they name in the order in which they
/// do.
TriangleMesh compacted(const std::vector<Vector3>& positions, std::vector<Triangle> triangles);

/// The triangles with these indices, ascending. Positions stay as they are, used or not; so do
/// materials. Parts without a triangle go.
TriangleMesh selected(TriangleMesh mesh, const std::vector<std::uint32_t>& faces);

/// Swaps the second corner of a triangle with its third, and turns its normals round.
void turn_over(TriangleMesh& mesh, std::size_t face);

/// Adds a triangle behind all others, with the material of the one beside it. Its corners get the
/// texture points and colors of that one's nearest points, and no normals.
void append(TriangleMesh& mesh, const Triangle& triangle, std::size_t beside);

/// The same of a triangle that covers a part of the other; its corners get normals, too.
void append_piece(TriangleMesh& mesh, const Triangle& triangle, std::size_t of);

/// Leaves out the positions that no triangle uses, and makes those of the same coordinates one, in
/// order of appearance. What corners carry stays theirs.
void compact(TriangleMesh& mesh);

}  // namespace rigor::mesh
