// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/primitive/fit_axis.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <rigor/mesh/primitive/principal_axes.h>

namespace rigor::mesh {
namespace {

/// Projections of a point: some tenths of a microsecond each, sorting included.
constexpr std::size_t kMaxProjections = 4'000'000;
constexpr std::size_t kMaxAxes = 400;
constexpr std::size_t kMinAxes = 12;

/// Axes closer than this (1 - cos of a milliradian) are one; tilting finds what lies between.
constexpr double kSameAxis = 5e-7;

struct Direction {
  double weight;
  Vector3 vector;
};

class Axes {
 public:
  explicit Axes(std::size_t limit) : limit_(limit) {}

  void add(const Vector3& v) {
    const double size = length(v);
    if (list_.size() >= limit_ || !(size > 0)) return;
    const Vector3 axis = (1 / size) * v;
    const auto same = [&axis](const Vector3& other) {
      return std::abs(dot(axis, other)) > 1 - kSameAxis;
    };
    if (std::none_of(list_.begin(), list_.end(), same)) list_.push_back(axis);
  }

  void add_heaviest(std::vector<Direction> directions) {
    std::stable_sort(directions.begin(), directions.end(),
                     [](const auto& a, const auto& b) { return a.weight > b.weight; });
    for (const Direction& direction : directions) add(direction.vector);
  }

  void raise_limit(std::size_t by) { limit_ = list_.size() + by; }

  std::vector<Vector3> list() && { return std::move(list_); }

 private:
  std::size_t limit_;
  std::vector<Vector3> list_;
};

}  // namespace

Basis basis_about(const Vector3& axis) {
  const Vector3 x{1, 0, 0};
  const Vector3 y{0, 1, 0};
  const Vector3 z{0, 0, 1};
  if (axis == x) return {y, z, x};
  if (axis == y) return {z, x, y};
  if (axis == z) return {x, y, z};
  const double ax = std::abs(axis.x);
  const double ay = std::abs(axis.y);
  const double az = std::abs(axis.z);
  const Vector3& far = ax <= ay && ax <= az ? x : ay <= az ? y : z;
  const Vector3 u = cross(far, axis);
  const Vector3 unit = (1 / length(u)) * u;
  return {unit, cross(axis, unit), axis};
}

std::vector<Vector3> axes_to_try(const TriangleMesh& hull) {
  const std::size_t affordable = kMaxProjections / (hull.positions.size() + 1);
  const std::size_t limit = std::clamp(affordable, kMinAxes, kMaxAxes);
  Axes axes(2 * kCoordinateAxes);
  for (const Vector3& axis : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}) axes.add(axis);
  for (const Vector3& axis : principal_axes(enclosed(hull).spread)) axes.add(axis);
  std::vector<Direction> normals;
  std::vector<Direction> edges;
  for (const Triangle& t : hull.triangles) {
    const Facet f = facet(hull, t);
    const Vector3 normal = area_vector(f);
    normals.push_back({length(normal), normal});
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 edge = f[(i + 1) % 3] - f[i];
      if (t[i] < t[(i + 1) % 3]) edges.push_back({length(edge), edge});
    }
  }
  axes.raise_limit(limit / 2);
  axes.add_heaviest(std::move(normals));
  axes.raise_limit(limit / 2);
  axes.add_heaviest(std::move(edges));
  return std::move(axes).list();
}

}  // namespace rigor::mesh
