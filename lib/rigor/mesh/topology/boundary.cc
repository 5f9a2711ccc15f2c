// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/topology/boundary.h>

#include <algorithm>
#include <utility>

namespace rigor::mesh {

Boundary boundary_of(const TriangleMesh& mesh, const Weld& welded,
                     const std::vector<BadEdge>& edges) {
  Boundary boundary;
  if (edges.empty()) return boundary;
  DisjointSets loops(welded.places());
  for (const BadEdge& edge : edges) {
    if (edge.defect == Defect::kBoundaryEdge) loops.join(edge.low, edge.high);
  }
  struct Loop {
    double length = 0;
    std::uint64_t edges = 0;
  };
  std::vector<Loop> of_place(welded.places());
  const auto at = [&](std::uint32_t place) { return mesh.positions[welded.first[place]]; };
  for (const BadEdge& edge : edges) {
    if (edge.defect != Defect::kBoundaryEdge) continue;
    Loop& loop = of_place[loops.find(edge.low)];
    loop.length += length(at(edge.high) - at(edge.low));
    ++loop.edges;
  }
  for (const Loop& loop : of_place) {
    if (loop.edges == 0) continue;
    ++boundary.loops;
    boundary.total_length += loop.length;
    const auto rank = [](double size, std::uint64_t count) { return std::pair(size, count); };
    if (rank(loop.length, loop.edges) > rank(boundary.longest_length, boundary.longest_edges)) {
      boundary.longest_length = loop.length;
      boundary.longest_edges = loop.edges;
    }
  }
  return boundary;
}

}  // namespace rigor::mesh
