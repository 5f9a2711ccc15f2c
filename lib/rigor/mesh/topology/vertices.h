// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What tells the corners at one place apart, and how a mesh is put together again from triangles of
// vertices: a vertex is a place, a part of the mesh and, where seams are kept, a texture point and a
// color. Normals are no part of it, as most files have other ones for each triangle.
//
//   Vertices vertices = vertices_of(mesh, welded, Seams::kKeep);
//   TriangleMesh result = assembled(mesh, vertices, surface);

#pragma once

#include <cstdint>
#include <vector>

#include <rigor/mesh/reduce.h>
#include <rigor/mesh/repair/pinch.h>
#include <rigor/mesh/topology/weld.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

struct Vertices {
  std::vector<std::uint32_t> faces;  ///< the triangles of the mesh that are not degenerate
  std::vector<std::uint32_t> index;  ///< of each of their corners, its vertex
  std::vector<std::uint32_t> place;  ///< of each vertex
  std::vector<std::uint32_t>
      part;  ///< of each vertex, where corners carry anything or parts are more
};

Vertices vertices_of(const TriangleMesh& mesh, const Weld& welded, Seams seams);

/// The surface's triangles as a mesh, part by part. A corner gets what the mesh's corners of the same
/// vertex carry: of several the one whose normal is nearest to the triangle's.
TriangleMesh assembled(const TriangleMesh& mesh, const Vertices& vertices,
                       const PinchedSurface& surface);

}  // namespace rigor::mesh
