// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Mends what collapsing edges does to a surface when nobody asks whether the two ends have more
// neighbors in common than their triangles show (the link condition; T. Dey, H. Edelsbrunner,
// S. Guha, D. Nekhayev, "Topology preserving edge contraction", 1999). Two triangles come to
// lie back to back, or a tetrahedron hangs on an edge: these are taken away. Or four triangles meet at
// an edge: two of them are turned to the other diagonal of their quadrangle, or get a vertex of the
// mesh back, so that each pair has an edge of its own. None of that opens an edge that was closed.
//
//   PinchedSurface surface(positions_of_places, place_of_vertex);
//   surface.take(faces);
//   const auto left = surface.mend(surface.bad_edges(), [&](const BadEdge& e) { return is_new(e); });

#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <rigor/mesh/repair/pinch_round.h>
#include <rigor/mesh/topology/rings.h>
#include <rigor/mesh/topology/weld.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// Triangles of vertices, of which several may be in one place: along a seam.
class PinchedSurface {
 public:
  using Chosen = std::function<bool(const BadEdge&)>;

  PinchedSurface(std::vector<Vector3> places, std::vector<std::uint32_t> place_of_vertex);

  /// Triangles with two corners in one place are left out.
  void take(std::vector<Triangle> faces);

  /// Mends the chosen of the bad edges, which are all that there are, as far as that goes. Returns
  /// those that there are then.
  std::vector<BadEdge> mend(std::vector<BadEdge> edges, const Chosen& chosen);

  /// The same where four triangles meet and none may be turned: two of them get a vertex of the mesh
  /// that has these corners, unless there were more triangles than so many then.
  std::vector<BadEdge> part(std::vector<BadEdge> edges, const Chosen& chosen,
                            const std::vector<std::uint32_t>& corners, std::size_t most);

  const std::vector<Triangle>& faces() const { return faces_; }
  const std::vector<Vector3>& places() const { return places_; }
  std::uint32_t place_of(std::uint32_t vertex) const { return place_[vertex]; }

  std::vector<BadEdge> bad_edges() const;
  std::uint64_t holes(std::vector<BadEdge> edges) const;

 private:
  using Step = std::function<bool(PinchRound&, const BadEdge&)>;

  std::uint32_t number(std::uint32_t place);
  void number_corners();
  Weld apart() const;
  BadEdge numbered(BadEdge edge) const;
  std::vector<BadEdge> in_rounds(std::vector<BadEdge> edges, const Chosen& chosen,
                                 const Step& step);
  std::vector<OldNeighbor> old_neighbors(const std::vector<BadEdge>& edges, const Chosen& chosen,
                                         const std::vector<std::uint32_t>& corners);

  std::vector<Vector3> places_;
  std::vector<std::uint32_t> place_;  // of each vertex
  std::vector<Triangle> faces_;       // of vertices
  // Few places are in use, and those have a number.
  std::vector<std::uint32_t> number_;  // of each place
  std::vector<std::uint32_t> used_;    // the place of each number
  TriangleMesh mesh_;                  // the same faces, of numbers
};

}  // namespace rigor::mesh
