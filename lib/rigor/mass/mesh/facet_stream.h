// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Everything that one pass over a mesh's triangles adds up, and that pass over a binary STL file in
// blocks on several threads.
//
//   FacetSums sums = stream_stl(*disk.open(path), count, 2);

#pragma once

#include <cstdint>

#include <rigor/mass/polyhedron.h>
#include <rigor/mesh/topology/edge_balance.h>
#include <rigor/mesh/topology/winding.h>
#include <rigor/mesh/triangle_mesh.h>
#include <rigor/text/disk.h>

namespace rigor::mass {

struct FacetSums {
  /// `around` need not be exact: the sums are taken about its middle, the winding probed within it.
  explicit FacetSums(const mesh::Bounds& around);

  void add(const mesh::Facet& facet);
  /// As if `later`'s facets had been added after this one's.
  void join(const FacetSums& later);

  std::uint64_t triangles = 0;
  mesh::Bounds bounds;
  PolyhedronSum polyhedron;
  mesh::EdgeBalance balance;
  mesh::WindingProbe winding;
};

/// The sums over `count` facets. `threads` of zero means as many as there are cores; the result does
/// not depend on it.
FacetSums stream_stl(const OpenFile& file, std::uint64_t count, unsigned threads);

}  // namespace rigor::mass
