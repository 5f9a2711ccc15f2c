// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a mesh's edges say: whether it is closed, and where not.
//
// Vertices are first welded by position, exactly (-0 is 0): the files' own indices keep corners apart
// that differ in normal or texture, and an STL has none. Triangles that have then two corners in one
// place are degenerate and count for nothing else.
//
//   Topology topology = topology_of(mesh);
//   if (topology.boundary_edges > 0) say("open");

#pragma once

#include <cstdint>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

struct Topology {
  std::uint64_t vertices = 0;  ///< places that triangles use
  std::uint64_t edges = 0;
  std::uint64_t boundary_edges = 0;      ///< with one triangle
  std::uint64_t nonmanifold_edges = 0;   ///< with more than two
  std::uint64_t inconsistent_edges = 0;  ///< with two that run the same way along it
  std::uint64_t degenerate = 0;          ///< triangles with two corners in one place
  std::uint64_t components = 0;          ///< of triangles that share corners

  bool closed() const {
    return boundary_edges == 0 && nonmanifold_edges == 0 && inconsistent_edges == 0;
  }
};

Topology topology_of(const TriangleMesh& mesh);

}  // namespace rigor::mesh
