// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/topology.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace rigor::mesh {
namespace {

bool before(const Vector3& a, const Vector3& b) {
  if (a.x != b.x) return a.x < b.x;
  if (a.y != b.y) return a.y < b.y;
  return a.z < b.z;
}

/// Of each position, the number of its place: equal positions have the same.
std::vector<std::uint32_t> weld(const std::vector<Vector3>& positions) {
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&positions](std::uint32_t a, std::uint32_t b) {
    return before(positions[a], positions[b]);
  });
  std::vector<std::uint32_t> place(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && !before(positions[order[i - 1]], positions[order[i]]);
    place[order[i]] = same ? place[order[i - 1]] : order[i];
  }
  return place;
}

/// Sets of places that edges join.
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }

  void join(std::uint32_t a, std::uint32_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<std::uint32_t> parent_;
};

/// An edge of a triangle, its ends in order; `forward` when the triangle runs from low to high.
struct Edge {
  std::uint32_t low;
  std::uint32_t high;
  std::uint32_t forward;

  bool joins_same(const Edge& other) const { return low == other.low && high == other.high; }
};

void count_edges(std::vector<Edge>& edges, Topology& topology) {
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  });
  for (std::size_t begin = 0; begin < edges.size();) {
    std::size_t end = begin;
    std::size_t forward = 0;
    for (; end < edges.size() && edges[end].joins_same(edges[begin]); ++end) {
      forward += edges[end].forward;
    }
    ++topology.edges;
    if (end - begin == 1) ++topology.boundary_edges;
    if (end - begin > 2) ++topology.nonmanifold_edges;
    if (end - begin == 2 && forward != 1) ++topology.inconsistent_edges;
    begin = end;
  }
}

}  // namespace

Topology topology_of(const TriangleMesh& mesh) {
  Topology topology;
  const std::vector<std::uint32_t> place = weld(mesh.positions);
  std::vector<Edge> edges;
  edges.reserve(mesh.triangles.size() * 3);
  std::vector<bool> used(mesh.positions.size(), false);
  Groups groups(mesh.positions.size());
  for (const Triangle& t : mesh.triangles) {
    const Triangle p{place[t[0]], place[t[1]], place[t[2]]};
    if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]) {
      ++topology.degenerate;
      continue;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = p[i];
      const std::uint32_t b = p[(i + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1U : 0U});
      used[a] = true;
      groups.join(a, b);
    }
  }
  count_edges(edges, topology);
  for (std::uint32_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    ++topology.vertices;
    if (groups.find(i) == i) ++topology.components;
  }
  return topology;
}

}  // namespace rigor::mesh
