// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/topology/old_flaws.h>

#include <algorithm>

#include <rigor/mesh/topology/bad_edges.h>
#include <rigor/mesh/topology/boundary.h>

namespace rigor::mesh {
namespace {

std::uint64_t count(const std::vector<BadEdge>& edges, Defect defect) {
  return static_cast<std::uint64_t>(std::count_if(
      edges.begin(), edges.end(), [defect](const BadEdge& e) { return e.defect == defect; }));
}

}  // namespace

OldFlaws::OldFlaws(const TriangleMesh& mesh, const Weld& welded, const std::vector<BadEdge>& now)
    : mesh_(mesh), welded_(welded), at_(welded.places()) {
  std::vector<std::uint32_t> places;
  bool open = false;
  for (const BadEdge& edge : now) {
    places.insert(places.end(), {edge.low, edge.high});
    open = open || edge.defect != Defect::kNonmanifoldEdge;
  }
  edges_ = bad_edges_at(mesh, welded, places, open);
  for (const BadEdge& edge : edges_) at_[edge.low] = at_[edge.high] = true;
}

std::uint64_t OldFlaws::holes() const { return boundary_of(mesh_, welded_, edges_).loops; }

std::uint64_t OldFlaws::added(const std::vector<BadEdge>& now, Defect defect) const {
  const std::uint64_t present = count(now, defect);
  return present - std::min(present, count(edges_, defect));
}

bool OldFlaws::sound() const { return edges_.empty() && bad_edges_of(mesh_, welded_).empty(); }

}  // namespace rigor::mesh
