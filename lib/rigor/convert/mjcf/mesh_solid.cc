// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/mjcf/mesh_solid.h>

#include <algorithm>
#include <utility>

#include <rigor/mesh/convex/hull.h>

namespace rigor::convert {
namespace {

using mesh::TriangleMesh;

/// m³, MuJoCo's mjMINVAL with a margin for its sums.
constexpr double kLeastVolume = 1e-13;

double signed_volume(const TriangleMesh& mesh) {
  double six = 0;
  for (const mesh::Triangle& t : mesh.triangles) {
    const auto [a, b, c] = facet(mesh, t);
    six += dot(a - mesh.positions[0], cross(b - mesh.positions[0], c - mesh.positions[0]));
  }
  return six / 6;
}

}  // namespace

std::optional<TriangleMesh> mujoco_hull(const std::vector<mesh::Vector3>& points) {
  return mesh::convex_hull(points);
}

MujocoSolid mujoco_solid(TriangleMesh mesh, MujocoUse use) {
  if (mesh.triangles.empty()) return {{}, {}, "without triangles"};
  if (use == MujocoUse::kCollision) {
    if (signed_volume(mesh) >= kLeastVolume) return {std::move(mesh), {}, {}};
    auto hull = mesh::convex_hull(mesh.positions);
    if (!hull || signed_volume(*hull) < kLeastVolume) return {{}, {}, "without volume"};
    return {std::move(hull), "is its convex hull", {}};
  }
  return {std::move(mesh), {}, {}};
}

}  // namespace rigor::convert
