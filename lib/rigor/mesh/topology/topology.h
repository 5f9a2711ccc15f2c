// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How a mesh's triangles hang together: whether it is closed, and where not; what is wrong with which
// triangle, edge or vertex; and the components it falls into.
//
// Vertices are first welded by position, exactly (weld.h). Triangles that have then two corners in one
// place are degenerate and count for nothing else.
//
//   Topology topology = topology_of(mesh);
//   if (topology.boundary_edges > 0) say("open");
//   for (const Example& example : topology.examples) show(example.at);

#pragma once

#include <cstdint>
#include <vector>

#include <rigor/mesh/topology/boundary.h>
#include <rigor/mesh/topology/component.h>
#include <rigor/mesh/topology/defect.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

struct Topology {
  std::uint64_t vertices = 0;  ///< places that triangles use
  std::uint64_t edges = 0;
  std::uint64_t triangles = 0;  ///< that are not degenerate

  std::uint64_t boundary_edges = 0;        ///< with one triangle
  std::uint64_t nonmanifold_edges = 0;     ///< with more than two
  std::uint64_t inconsistent_edges = 0;    ///< with two that run the same way along it
  std::uint64_t nonmanifold_vertices = 0;  ///< whose triangles fall into several fans
  std::uint64_t degenerate = 0;            ///< triangles with two corners in one place
  std::uint64_t zero_area = 0;             ///< triangles with three places on a line
  std::uint64_t slivers = 0;               ///< thinner than `kSliverRatio`, but with an area
  std::uint64_t duplicates = 0;  ///< triangles with the places of one before, in either orientation
  std::uint64_t unreferenced = 0;  ///< positions that no triangle names
  std::vector<Example> examples;   ///< up to `kMaxExamples` of each of the above

  Boundary boundary;

  std::uint64_t components = 0;  ///< of triangles that edges join
  std::uint64_t inverted = 0;    ///< closed components that are inside out, and in no other
  std::uint64_t cavities = 0;
  std::uint64_t doubled = 0;              ///< closed components in others that face the same way
  std::uint64_t not_nested = 0;           ///< closed components of which that was not examined
  std::vector<Component> component_list;  ///< in the order of their first triangles

  /// Without holes, whichever way its triangles run. Triangles without an area bound nothing, so a
  /// mesh of such alone, or of none, is not watertight.
  bool watertight() const {
    return triangles > zero_area && boundary_edges == 0 && nonmanifold_edges == 0;
  }

  bool closed() const { return watertight() && inconsistent_edges == 0; }

  /// Vertices - edges + triangles: 2 for a sphere, 0 for a torus, added up over components.
  std::int64_t euler() const { return static_cast<std::int64_t>(vertices - edges + triangles); }
};

Topology topology_of(const TriangleMesh& mesh);

}  // namespace rigor::mesh
