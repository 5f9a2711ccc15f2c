// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Proves in one pass, without a table of edges, that a mesh is closed and consistently wound.
//
// In such a mesh every directed edge is met by its reverse. Each directed edge adds a 64-bit hash of
// its end points to a sum, with the sign of its direction; what meets its reverse cancels, so the sum
// of a closed mesh is zero. A mesh that is not closed gives zero once in 2^64 cases. End points are
// compared by their exact coordinates (-0 is 0), as nothing else welds the vertices of an STL file.
//
//   EdgeBalance balance;
//   for (const Triangle& t : mesh.triangles) balance.add(facet(mesh, t));
//   if (!balance.closed()) diagnose(topology_of(mesh));   // which edges are open
//
// Triangles without an area balance as well, and so does a mesh without triangles: they enclose
// nothing, so a mesh of such alone is not closed.
//
// More than two triangles at an edge balance as well, when as many run one way as the other: what they
// enclose is still well defined. That a mesh counts a place twice is for `Winding` to say.

#pragma once

#include <cstdint>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

class EdgeBalance {
 public:
  void add(const Facet& facet);

  /// The sums of two parts of a mesh are that of the whole, in any order.
  void join(const EdgeBalance& other) {
    sum_ += other.sum_;
    has_area_ = has_area_ || other.has_area_;
  }

  bool closed() const { return has_area_ && sum_ == 0; }

 private:
  std::uint64_t sum_ = 0;  // modulo 2^64
  bool has_area_ = false;  // some triangle has
};

}  // namespace rigor::mesh
