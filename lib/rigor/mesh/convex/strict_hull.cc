// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/convex/strict_hull.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <rigor/mesh/convex/hull.h>

namespace rigor::mesh {
namespace {

/// Corners seen from triangles, a few nanoseconds each.
constexpr std::uint64_t kMaxHullLooks = 200'000'000;

struct Above {
  double height = 0;
  std::array<std::uint32_t, 4> corners{};  // of the face, and the one above it
};

Above worst(const TriangleMesh& hull) {
  Above result;
  for (const Triangle& t : hull.triangles) {
    const Facet f = facet(hull, t);
    const Vector3 normal = area_vector(f);
    const double area = length(normal);
    if (area == 0) continue;
    for (std::uint32_t i = 0; i < hull.positions.size(); ++i) {
      const double height = dot(normal, hull.positions[i] - f[0]) / area;
      if (height > result.height) result = {height, {t[0], t[1], t[2], i}};
    }
  }
  return result;
}

/// Above a face of an ill direction a point seems far out, so this errs to the safe side.
double outside(const TriangleMesh& hull, const Vector3& p) {
  double most = 0;
  for (const Triangle& t : hull.triangles) {
    const Facet f = facet(hull, t);
    const Vector3 normal = area_vector(f);
    const double area = length(normal);
    if (area > 0) most = std::max(most, dot(normal, p - f[0]) / area);
  }
  return most;
}

std::optional<TriangleMesh> without(const TriangleMesh& hull, std::uint32_t corner) {
  std::vector<Vector3> points = hull.positions;
  points.erase(points.begin() + corner);
  return convex_hull(points);
}

/// What remains when the one of these corners that matters least is left out.
std::optional<TriangleMesh> lessened(const TriangleMesh& hull, const Above& above, double limit) {
  std::optional<TriangleMesh> best;
  for (const std::uint32_t corner : above.corners) {
    auto rest = without(hull, corner);
    if (!rest) continue;
    const double lost = outside(*rest, hull.positions[corner]);
    if (lost > limit) continue;
    limit = lost;
    best = std::move(rest);
  }
  return best;
}

}  // namespace

TriangleMesh made_strict(TriangleMesh hull) {
  const double size = diagonal(bounds_of(hull.positions));
  std::uint64_t looks = 0;
  while (looks < kMaxHullLooks) {
    const Above above = worst(hull);
    if (above.height <= kConvex * size) break;
    auto rest = lessened(hull, above, kLeftOut * size);
    if (!rest) break;
    looks += hull.positions.size() * hull.triangles.size();
    hull = std::move(*rest);
  }
  return hull;
}

}  // namespace rigor::mesh
