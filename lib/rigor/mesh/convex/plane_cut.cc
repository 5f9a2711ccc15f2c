// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/convex/plane_cut.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include <rigor/mesh/repair/cap.h>
#include <rigor/mesh/select.h>
#include <rigor/mesh/topology/weld.h>

namespace rigor::mesh {
namespace {

/// An edge, and how often more it is run along from low to high than back.
struct Edge {
  std::uint32_t low;
  std::uint32_t high;
  int turns;
};

std::vector<DirectedEdge> sorted_edges(std::vector<DirectedEdge> edges) {
  std::sort(edges.begin(), edges.end());
  return edges;
}

class PlaneCutter {
 public:
  PlaneCutter(const TriangleMesh& mesh, const Plane& plane, double on_plane)
      : normal_(plane.normal) {
    const Weld welded = weld(mesh.positions);
    double farthest = 0;
    for (const std::uint32_t i : welded.first) {
      const Vector3& p = mesh.positions[i];
      positions_.push_back(p);
      height_.push_back(dot(plane.normal, p) - plane.offset);
      farthest = std::max({farthest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
    const double tolerance = on_plane * diagonal(bounds_of(positions_)) +
                             4 * std::numeric_limits<double>::epsilon() * farthest;
    for (double& height : height_) {
      if (std::abs(height) <= tolerance) height = 0;
    }
    for (const Triangle& t : mesh.triangles) {
      add({welded.place[t[0]], welded.place[t[1]], welded.place[t[2]]});
    }
  }

  Halves halves() && {
    const auto below = missing(below_);
    auto above = missing(above_);
    const std::vector<Triangle> cap = cap_of(below, positions_, normal_);
    below_.insert(below_.end(), cap.begin(), cap.end());
    for (DirectedEdge& edge : above) std::swap(edge[0], edge[1]);
    // With triangles in the plane, what the halves lack differs. Otherwise they share a cap, and their
    // volumes add up though its corners are in the plane only nearly.
    const bool same = sorted_edges(below) == sorted_edges(above);
    for (const Triangle& t : same ? cap : cap_of(above, positions_, normal_)) {
      above_.push_back({t[0], t[2], t[1]});
    }
    return {compacted(positions_, std::move(below_)), compacted(positions_, std::move(above_))};
  }

 private:
  void add(const Triangle& t) {
    const auto [low, high] = std::minmax({height_[t[0]], height_[t[1]], height_[t[2]]});
    if (high <= 0 && low < 0) below_.push_back(t);
    if (low >= 0 && high > 0) above_.push_back(t);
    if (low >= 0 || high <= 0) return;
    clip(t, -1, below_);
    clip(t, 1, above_);
  }

  /// What of the triangle lies on the side of this sign.
  void clip(const Triangle& t, double sign, std::vector<Triangle>& half) {
    std::array<std::uint32_t, 4> polygon{};
    std::size_t size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i];
      const std::uint32_t b = t[(i + 1) % 3];
      if (sign * height_[a] >= 0) polygon[size++] = a;
      if (height_[a] * height_[b] < 0) polygon[size++] = crossing(std::min(a, b), std::max(a, b));
    }
    for (std::size_t i = 2; i < size; ++i) half.push_back({polygon[0], polygon[i - 1], polygon[i]});
  }

  /// The same vertex for both triangles at the edge.
  std::uint32_t crossing(std::uint32_t low, std::uint32_t high) {
    const auto next = static_cast<std::uint32_t>(positions_.size());
    const auto [entry, is_new] = crossings_.try_emplace(std::uint64_t{low} << 32U | high, next);
    if (is_new) {
      const double share = height_[low] / (height_[low] - height_[high]);
      positions_.push_back(positions_[low] + share * (positions_[high] - positions_[low]));
      height_.push_back(0);
    }
    return entry->second;
  }

  /// The edges in the plane that the half has and its cap must have in reverse, as that has them.
  std::vector<DirectedEdge> missing(const std::vector<Triangle>& half) const {
    std::vector<Edge> edges;
    for (const Triangle& t : half) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = t[i];
        const std::uint32_t b = t[(i + 1) % 3];
        if (a == b || height_[a] != 0 || height_[b] != 0) continue;
        edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1});
      }
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
      return std::tie(a.low, a.high) < std::tie(b.low, b.high);
    });
    std::vector<DirectedEdge> result;
    for (std::size_t i = 0; i < edges.size();) {
      const Edge& edge = edges[i];
      int turns = 0;
      for (; i < edges.size() && edges[i].low == edge.low && edges[i].high == edge.high; ++i) {
        turns += edges[i].turns;
      }
      for (int k = 0; k < turns; ++k) result.push_back({edge.high, edge.low});
      for (int k = 0; k > turns; --k) result.push_back({edge.low, edge.high});
    }
    return result;
  }

  Vector3 normal_;
  std::vector<Vector3> positions_;
  std::vector<double> height_;  // above the plane; zero on it
  std::unordered_map<std::uint64_t, std::uint32_t> crossings_;
  std::vector<Triangle> below_;
  std::vector<Triangle> above_;
};

}  // namespace

Halves cut(const TriangleMesh& mesh, const Plane& plane, double on_plane) {
  return PlaneCutter(mesh, plane, on_plane).halves();
}

}  // namespace rigor::mesh
