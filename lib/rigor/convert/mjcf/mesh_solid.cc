// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/mjcf/mesh_solid.h>

#include <utility>

#include <fmt/format.h>

#include <rigor/mesh/convex/hull.h>

namespace rigor::convert {
namespace {

using mesh::TriangleMesh;

/// m³, MuJoCo's mjMINVAL with a margin for its sums.
constexpr double kLeastVolume = 1e-13;

/// A mesh that fills its hull to this share collides as it is drawn, but for a dent.
constexpr double kConvexShare = 0.95;

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
  if (mesh.triangles.empty()) return {{}, false, {}, "without triangles"};
  if (use == MujocoUse::kVisual) return {std::move(mesh)};
  auto hull = mesh::convex_hull(mesh.positions);
  const double hulled = hull ? signed_volume(*hull) : 0;
  if (hulled < kLeastVolume) return {{}, false, {}, "without volume"};
  const double volume = signed_volume(mesh);
  if (volume < kLeastVolume) return {std::move(hull), true, "becomes its convex hull"};
  if (volume > kConvexShare * hulled) return {std::move(mesh)};
  return {std::move(mesh), false,
          fmt::format("collides as its convex hull, of {:.2g} times its volume", hulled / volume)};
}

}  // namespace rigor::convert
