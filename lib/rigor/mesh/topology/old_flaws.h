// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What was wrong with a mesh before it was changed, beside what is wrong with it now. Non-manifold edges
// are looked for only where something is wrong now.
//
//   OldFlaws old(mesh, welded, edges);
//   if (old.is_new(edges.front())) mend();

#pragma once

#include <cstdint>
#include <vector>

#include <rigor/mesh/topology/rings.h>
#include <rigor/mesh/topology/weld.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

class OldFlaws {
 public:
  /// `now` are all bad edges that there are now, between the mesh's places. The mesh must outlive this.
  OldFlaws(const TriangleMesh& mesh, const Weld& welded, const std::vector<BadEdge>& now);

  /// Whether one of its ends was at no bad edge. Only for edges between ends of those given.
  bool is_new(const BadEdge& edge) const { return !at_[edge.low] || !at_[edge.high]; }

  /// How many more there are now than there were: of non-manifold edges, at the same places.
  std::uint64_t added(const std::vector<BadEdge>& now, Defect defect) const;

  /// Only where some edge is open now.
  std::uint64_t holes() const;

  /// Whether nothing was wrong at all.
  bool sound() const;

 private:
  const TriangleMesh& mesh_;
  const Weld& welded_;
  std::vector<BadEdge> edges_;
  std::vector<bool> at_;  // places that one of these ends at
};

}  // namespace rigor::mesh
