// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The triangles round each vertex of a welded mesh. All that is to know of its edges, fans and doubled
// triangles is seen from there, so no table of edges is built.
//
// An edge counts at its lower end, a triangle at its lowest corner. Round most vertices each triangle
// leads to the next across one edge until the first comes again; such a ring is known to be sound
// after one walk. Only the others are sorted and examined one by one.
//
//   Rings rings = look_round(mesh, welded, tally);

#pragma once

#include <cstdint>
#include <vector>

#include <rigor/mesh/topology/defect.h>
#include <rigor/mesh/topology/weld.h>
#include <rigor/mesh/triangle_mesh.h>
#include <rigor/text/disjoint_sets.h>

namespace rigor::mesh {

/// One that not two triangles share in opposite directions.
struct BadEdge {
  std::uint32_t low;  ///< places
  std::uint32_t high;
  std::uint32_t face;  ///< one at it
  Defect defect;
};

struct Rings {
  std::uint64_t vertices = 0;  ///< places with triangles
  std::uint64_t edges = 0;
  std::vector<BadEdge> bad_edges;
  DisjointSets faces{0};  ///< the triangles, joined across edges
};

/// The corners of a triangle as places, and whether these are three.
inline Triangle places_of(const Weld& welded, const Triangle& t) {
  return {welded.place[t[0]], welded.place[t[1]], welded.place[t[2]]};
}

inline bool degenerate(const Triangle& places) {
  return places[0] == places[1] || places[1] == places[2] || places[2] == places[0];
}

/// Degenerate triangles are passed over.
Rings look_round(const TriangleMesh& mesh, const Weld& welded, DefectTally& tally);

}  // namespace rigor::mesh
