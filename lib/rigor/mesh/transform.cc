// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/transform.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <rigor/mesh/normals.h>
#include <rigor/mesh/select.h>

namespace rigor::mesh {
namespace {

/// By signs: the product of tiny factors could become zero.
bool mirrors(const Transform& by) {
  bool negative = false;
  for (const double factor : {by.unit, by.unit, by.unit, by.scale.x, by.scale.y, by.scale.z}) {
    negative = negative != (factor < 0);
  }
  return negative;
}

/// Halved first, so that the sum of two large numbers is no infinity.
Vector3 middle_of(const Bounds& bounds) { return 0.5 * bounds.min + 0.5 * bounds.max; }

/// What comes to lie at the origin, of the mesh as it is before the centering.
Vector3 center_of(const TriangleMesh& mesh, const Transform& by) {
  if (by.center == Center::kNone || mesh.triangles.empty()) return {};
  if (by.center == Center::kPoint) return before_centering(by, by.point);
  const Bounds bounds = bounds_of(used_positions(mesh));
  Vector3 center = middle_of(bounds);
  if (by.center == Center::kBottom) center.z = bounds.min.z;
  return center;
}

/// From the axes of the mesh to those of the result.
Vector3 turned_up(UpAxis up, const Vector3& v) {
  return up == UpAxis::kZ ? v : Vector3{v.x, 0 - v.z, v.y};  // of a zero no -0
}

/// The cofactors of the scale, which take the normals of a surface to those of the scaled one, but
/// for their lengths. Of factors of 1 at most, so that no product is too large.
Vector3 cofactors(const Vector3& scale) {
  const double most = std::max({std::abs(scale.x), std::abs(scale.y), std::abs(scale.z)});
  const Vector3 s{scale.x / most, scale.y / most, scale.z / most};
  return {s.y * s.z, s.z * s.x, s.x * s.y};
}

void turn_normals(TriangleMesh& mesh, const Transform& by) {
  const Vector3 factors = cofactors(by.scale);
  for (std::array<Corners::Normal, 3>& corners : mesh.corners.normals) {
    for (Corners::Normal& n : corners) {
      n = normal_along(turned_up(
          by.up, {factors.x * double{n[0]}, factors.y * double{n[1]}, factors.z * double{n[2]}}));
    }
  }
}

}  // namespace

Vector3 before_centering(const Transform& by, const Vector3& p) {
  return turned_up(
      by.up, {p.x * by.unit * by.scale.x, p.y * by.unit * by.scale.y, p.z * by.unit * by.scale.z});
}

Transformed transformed(TriangleMesh mesh, const Transform& by) {
  for (Vector3& p : mesh.positions) p = before_centering(by, p);
  turn_normals(mesh, by);
  if (mirrors(by)) {
    for (std::size_t face = 0; face < mesh.triangles.size(); ++face) turn_over(mesh, face);
  }
  const Vector3 translation = Vector3{} - center_of(mesh, by);
  for (Vector3& p : mesh.positions) p = p + translation;
  return {std::move(mesh), translation};
}

}  // namespace rigor::mesh
