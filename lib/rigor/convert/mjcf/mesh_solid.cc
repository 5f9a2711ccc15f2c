// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/mjcf/mesh_solid.h>

#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include <rigor/mesh/convex/hull.h>
#include <rigor/mesh/select.h>

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

/// As shares of its diagonal: what a flat mesh is off its plane by rounding, and what it is thick then.
constexpr double kFlat = 1e-6;
constexpr double kThickness = 1e-4;

/// The unit normal of a mesh whose vertices lie in one plane; nothing for others.
std::optional<mesh::Vector3> plane_of(const TriangleMesh& mesh) {
  mesh::Vector3 normal;
  for (const mesh::Triangle& t : mesh.triangles) {
    const mesh::Vector3 n = mesh::area_vector(mesh::facet(mesh, t));
    if (length(n) > length(normal)) normal = n;
  }
  if (!(length(normal) > 0)) return std::nullopt;
  normal = 1 / length(normal) * normal;
  const double room = kFlat * mesh::diagonal(mesh::bounds_of(mesh.positions));
  const double height = dot(normal, mesh.positions[mesh.triangles[0][0]]);
  for (const mesh::Vector3& p : mesh.positions) {
    if (std::abs(dot(normal, p) - height) > room) return std::nullopt;
  }
  return normal;
}

/// With its back behind it, on which the picture is the same.
TriangleMesh thickened(TriangleMesh mesh, const mesh::Vector3& normal) {
  const double thickness = kThickness * mesh::diagonal(mesh::bounds_of(mesh.positions));
  const auto count = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    mesh.positions.push_back(mesh.positions[i] - thickness * normal);
  }
  const std::size_t triangles = mesh.triangles.size();
  auto& texture = mesh.corners.texture;
  for (std::size_t i = 0; i < triangles; ++i) {
    if (dot(mesh::area_vector(mesh::facet(mesh, mesh.triangles[i])), normal) < 0) {
      mesh::turn_over(mesh, i);
    }
    const auto [a, b, c] = mesh.triangles[i];
    mesh.triangles.push_back({a + count, c + count, b + count});
    if (!texture.empty()) texture.push_back({texture[i][0], texture[i][2], texture[i][1]});
  }
  mesh.parts = {{.count = mesh.triangles.size()}};
  mesh::compact(mesh);
  return mesh;
}

}  // namespace

std::optional<TriangleMesh> mujoco_hull(const std::vector<mesh::Vector3>& points) {
  return mesh::convex_hull(points);
}

MujocoSolid mujoco_solid(TriangleMesh mesh, MujocoUse use) {
  if (mesh.triangles.empty()) return {{}, false, {}, "without triangles"};
  if (use == MujocoUse::kVisual) {
    const auto normal = plane_of(mesh);
    if (!normal) return {std::move(mesh)};
    return {thickened(std::move(mesh), *normal), true, "is flat, and gets a back to have a volume"};
  }
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
