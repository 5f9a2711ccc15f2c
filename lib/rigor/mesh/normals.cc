// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/normals.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <rigor/mesh/topology/weld.h>
#include <rigor/text/disjoint_sets.h>

namespace rigor::mesh {
namespace {

// Three coordinates rounded to 32 bits make a length wrong by 2^-24 · √3 at most: 1.04e-7.
constexpr double kUnitRounding = 1.1e-7;

/// Not by its inverse, which of the smallest numbers is infinite.
Vector3 over(const Vector3& v, double size) { return {v.x / size, v.y / size, v.z / size}; }

/// One side of a triangle: from which place to which, the lower first, and the corner that it
/// begins at, counted through all triangles.
struct TriangleSide {
  std::uint32_t low;
  std::uint32_t high;
  std::uint32_t corner;

  bool along(const TriangleSide& other) const { return low == other.low && high == other.high; }
  bool operator<(const TriangleSide& other) const {
    if (low != other.low) return low < other.low;
    return high != other.high ? high < other.high : corner < other.corner;
  }
};

std::uint32_t next_corner(std::uint32_t corner) {
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}

std::vector<std::uint32_t> places_of_corners(const TriangleMesh& mesh) {
  const Weld welded = weld(mesh.positions);
  std::vector<std::uint32_t> places;
  places.reserve(3 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) places.push_back(welded.place[corner]);
  }
  return places;
}

std::vector<TriangleSide> sorted_sides(const std::vector<std::uint32_t>& places) {
  std::vector<TriangleSide> sides;
  sides.reserve(places.size());
  for (std::uint32_t corner = 0; corner < places.size(); ++corner) {
    const auto [low, high] = std::minmax(places[corner], places[next_corner(corner)]);
    sides.push_back({low, high, corner});
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// Zero for a triangle without area, which is so smooth with nothing.
std::vector<Vector3> face_normals(const TriangleMesh& mesh) {
  std::vector<Vector3> normals;
  normals.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const auto [a, b, c] = facet(mesh, t);
    const Vector3 out = cross(b - a, c - a);
    const double size = length(out);
    normals.push_back(size > 0 && std::isfinite(size) ? over(out, size) : Vector3{});
  }
  return normals;
}

/// Of directions of length 1; exact for small angles too, unlike the arc cosine.
double angle_between(const Vector3& a, const Vector3& b) {
  return std::atan2(length(cross(a, b)), dot(a, b));
}

/// Corners in one place that see each other across smooth edges.
DisjointSets smooth_groups(const std::vector<std::uint32_t>& places,
                           const std::vector<Vector3>& normals, double crease_angle) {
  const std::vector<TriangleSide> sides = sorted_sides(places);
  DisjointSets groups(places.size());
  for (std::size_t first = 0, end = 0; first < sides.size(); first = end) {
    while (end < sides.size() && sides[end].along(sides[first])) ++end;
    if (end - first != 2) continue;
    const std::array<std::uint32_t, 2> from{sides[first].corner, sides[first + 1].corner};
    const std::array<std::uint32_t, 2> to{next_corner(from[0]), next_corner(from[1])};
    const Vector3& a = normals[from[0] / 3];
    const Vector3& b = normals[from[1] / 3];
    if (a == Vector3{} || b == Vector3{} || angle_between(a, b) > crease_angle) continue;
    const bool opposed = places[from[0]] == places[to[1]];
    groups.join(from[0], opposed ? to[1] : from[1]);
    groups.join(to[0], opposed ? from[1] : to[1]);
  }
  return groups;
}

/// The angle at a triangle's corner.
double angle_at(const Facet& f, std::size_t corner) {
  const Vector3 a = f[(corner + 1) % 3] - f[corner];
  const Vector3 b = f[(corner + 2) % 3] - f[corner];
  return std::atan2(length(cross(a, b)), dot(a, b));
}

/// Without -0.
Corners::Normal as_normal(const Vector3& v) {
  return {static_cast<float>(v.x) + 0.0F, static_cast<float>(v.y) + 0.0F,
          static_cast<float>(v.z) + 0.0F};
}

}  // namespace

TriangleMesh recomputed_normals(TriangleMesh mesh, double crease_angle) {
  const std::vector<Vector3> faces = face_normals(mesh);
  const std::vector<std::uint32_t> places = places_of_corners(mesh);
  DisjointSets groups = smooth_groups(places, faces, crease_angle);
  std::vector<Vector3> sums(places.size());
  for (std::uint32_t corner = 0; corner < places.size(); ++corner) {
    Vector3& sum = sums[groups.find(corner)];
    const double angle = angle_at(facet(mesh, mesh.triangles[corner / 3]), corner % 3);
    sum = sum + angle * faces[corner / 3];
  }
  mesh.corners.normals.assign(mesh.triangles.size(), {});
  for (std::uint32_t corner = 0; corner < places.size(); ++corner) {
    mesh.corners.normals[corner / 3][corner % 3] = normal_along(sums[groups.find(corner)]);
  }
  return mesh;
}

Corners::Normal normal_along(const Vector3& direction) {
  const double size = length(direction);
  if (size == 0 || !std::isfinite(size)) return {};
  const Corners::Normal as_it_is = as_normal(direction);
  const bool is_normal = std::abs(size - 1) <= kUnitRounding && as_vector(as_it_is) == direction;
  return is_normal ? as_it_is : as_normal(over(direction, size));
}

Corners::Normal normal_of(const Facet& f) { return normal_along(area_vector(f)); }

Vector3 as_vector(const Corners::Normal& normal) {
  return {double{normal[0]}, double{normal[1]}, double{normal[2]}};
}

}  // namespace rigor::mesh
