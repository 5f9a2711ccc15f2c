// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/convex/cut_planes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

#include <rigor/mesh/primitive/principal_axes.h>

namespace rigor::mesh {
namespace {

/// Planes that agree this closely are one: a hundredth of a unit vector, and of the diagonal.
constexpr double kNormalStep = 0.01;
constexpr double kOffsetStep = 0.01;

/// Sine of the angle between faces below which an edge is flat, whatever rounding made of it.
constexpr double kFlatEdge = 1e-3;

struct EdgeSide {
  std::uint32_t low;
  std::uint32_t high;
  std::uint32_t opposite;
  std::uint32_t face;
};

std::vector<EdgeSide> sides_of(const TriangleMesh& mesh) {
  std::vector<EdgeSide> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
    const Triangle& t = mesh.triangles[face];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i];
      const std::uint32_t b = t[(i + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t[(i + 2) % 3], face});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const EdgeSide& a, const EdgeSide& b) {
    return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
  });
  return sides;
}

Vector3 unit(const Vector3& v) {
  const double size = length(v);
  return size > 0 ? (1 / size) * v : Vector3{};
}

Vector3 unit_normal(const TriangleMesh& mesh, std::uint32_t face) {
  const Facet f = facet(mesh, mesh.triangles[face]);
  return unit(area_vector(f));
}

/// Planes with what speaks for them, those that nearly agree taken together.
class Ballot {
 public:
  explicit Ballot(double size) : size_(size) {}

  void vote(const Vector3& normal, const Vector3& through, double weight) {
    if (normal == Vector3{}) return;
    const double lead = std::max({normal.x, normal.y, normal.z});
    const bool turn = -std::min({normal.x, normal.y, normal.z}) > lead;
    const Vector3 n = turn ? -1.0 * normal : normal;
    const double offset = dot(n, through);
    const auto step = [](double value, double by) {
      return static_cast<std::int64_t>(std::floor(value / by + 0.5));
    };
    Entry& entry = entries_[{step(n.x, kNormalStep), step(n.y, kNormalStep), step(n.z, kNormalStep),
                             step(offset, kOffsetStep * size_)}];
    entry.weight += weight;
    if (weight <= entry.heaviest) return;
    entry.heaviest = weight;
    entry.plane = {n, offset};
  }

  std::vector<CutPlane> heaviest(std::size_t count, double total) const {
    std::vector<CutPlane> planes;
    for (const auto& [key, entry] : entries_) planes.push_back({entry.plane, entry.weight / total});
    std::stable_sort(planes.begin(), planes.end(),
                     [](const auto& a, const auto& b) { return a.concave > b.concave; });
    if (planes.size() > count) planes.resize(count);
    return planes;
  }

 private:
  struct Entry {
    Plane plane;
    double heaviest = 0;
    double weight = 0;
  };

  double size_;
  std::map<std::array<std::int64_t, 4>, Entry> entries_;
};

std::vector<CutPlane> through_concave_edges(const TriangleMesh& mesh, std::size_t count) {
  const std::vector<EdgeSide> sides = sides_of(mesh);
  Ballot ballot(diagonal(bounds_of(mesh.positions)));
  double total = 0;
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const EdgeSide& a = sides[i - 1];
    const EdgeSide& b = sides[i];
    if (a.low != b.low || a.high != b.high) continue;
    const Vector3& from = mesh.positions[a.low];
    const Vector3 edge = mesh.positions[a.high] - from;
    const Vector3 n = unit_normal(mesh, a.face);
    const Vector3 m = unit_normal(mesh, b.face);
    const double sine = length(cross(n, m));
    if (sine < kFlatEdge || dot(n, mesh.positions[b.opposite] - from) <= 0) continue;
    const double weight = length(edge) * sine;
    total += weight;
    ballot.vote(n, from, weight);
    ballot.vote(m, from, weight);
    ballot.vote(unit(n - m), from, weight);
  }
  return ballot.heaviest(count, total);
}

}  // namespace

std::vector<CutPlane> planes_to_try(const TriangleMesh& mesh, std::size_t count) {
  std::vector<CutPlane> planes = through_concave_edges(mesh, count / 2);
  std::vector<Vector3> normals = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const Vector3& axis : principal_axes(enclosed(mesh).spread)) normals.push_back(axis);
  const std::size_t levels = (count - planes.size()) / normals.size();
  for (const Vector3& normal : normals) {
    const auto along = [&normal](const Vector3& a, const Vector3& b) {
      return dot(normal, a) < dot(normal, b);
    };
    const auto [low, high] =
        std::minmax_element(mesh.positions.begin(), mesh.positions.end(), along);
    const double start = dot(normal, *low);
    const double step = (dot(normal, *high) - start) / static_cast<double>(levels + 1);
    for (std::size_t i = 1; i <= levels; ++i) {
      planes.push_back({{normal, start + static_cast<double>(i) * step}, 0});
    }
  }
  return planes;
}

}  // namespace rigor::mesh
