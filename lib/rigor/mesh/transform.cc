// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/transform.h>

#include <utility>
#include <vector>

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

std::vector<Vector3> used_positions(const TriangleMesh& mesh) {
  std::vector<bool> used(mesh.positions.size());
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) used[corner] = true;
  }
  std::vector<Vector3> positions;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i]) positions.push_back(mesh.positions[i]);
  }
  return positions;
}

/// Halved first, so that the sum of two large numbers is no infinity.
Vector3 middle_of(const Bounds& bounds) { return 0.5 * bounds.min + 0.5 * bounds.max; }

/// What comes to lie at the origin, of the mesh as it is before the centring.
Vector3 center_of(const TriangleMesh& mesh, const Transform& by) {
  if (by.center == Center::kNone || mesh.triangles.empty()) return {};
  if (by.center == Center::kPoint) return before_centering(by, by.point);
  const Bounds bounds = bounds_of(used_positions(mesh));
  Vector3 center = middle_of(bounds);
  if (by.center == Center::kBottom) center.z = bounds.min.z;
  return center;
}

}  // namespace

Vector3 before_centering(const Transform& by, const Vector3& p) {
  const Vector3 q{p.x * by.unit * by.scale.x, p.y * by.unit * by.scale.y,
                  p.z * by.unit * by.scale.z};
  if (by.up == UpAxis::kZ) return q;
  return {q.x, 0 - q.z, q.y};  // of a zero no -0
}

Transformed transformed(TriangleMesh mesh, const Transform& by) {
  for (Vector3& p : mesh.positions) p = before_centering(by, p);
  if (mirrors(by)) {
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  }
  const Vector3 translation = Vector3{} - center_of(mesh, by);
  for (Vector3& p : mesh.positions) p = p + translation;
  return {std::move(mesh), translation};
}

}  // namespace rigor::mesh
