// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/convex/convexity.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <rigor/mesh/convex/flip_hull.h>
#include <rigor/mesh/convex/hull.h>
#include <rigor/mesh/primitive/principal_axes.h>

namespace rigor::mesh {
namespace {

// Triangles whose plane is tried. Of a mesh with a dent of a hundredth of its surface one of them
// lies there nearly always.
constexpr std::size_t kTried = 200;

// Multiples of it fall into [0, 1) evenly, and not in step with the rows of a grid.
constexpr double kGoldenRatio = 0.6180339887498949;

// Height above a plane that is none, as a share of the diagonal: rounding of 32-bit coordinates.
constexpr double kLevel = 1e-5;

struct TriedPlane {
  Vector3 normal;  ///< of any length
  double limit;    ///< of points times the normal
};

std::vector<TriedPlane> tried_planes(const TriangleMesh& mesh) {
  const double slack = kLevel * diagonal(bounds_of(mesh.positions));
  std::vector<TriedPlane> planes;
  for (std::size_t i = 1; i <= kTried; ++i) {
    const double at = std::fmod(static_cast<double>(i) * kGoldenRatio, 1.0);
    const auto face = static_cast<std::size_t>(at * static_cast<double>(mesh.triangles.size()));
    const Facet f = facet(mesh, mesh.triangles[face]);
    const Vector3 normal = area_vector(f);
    planes.push_back({normal, model::dot(normal, f[0]) + slack * model::length(normal)});
  }
  return planes;
}

/// Whether the first corners of all triangles are below the planes.
bool all_below(const TriangleMesh& mesh, const std::vector<TriedPlane>& planes) {
  std::vector<bool> seen(mesh.positions.size());
  for (const Triangle& t : mesh.triangles) {
    if (seen[t[0]]) continue;
    seen[t[0]] = true;
    const Vector3& p = mesh.positions[t[0]];
    const bool below = std::all_of(planes.begin(), planes.end(), [&p](const TriedPlane& plane) {
      return model::dot(plane.normal, p) <= plane.limit;
    });
    if (!below) return false;
  }
  return true;
}

}  // namespace

bool is_convex(const TriangleMesh& mesh, double volume) {
  if (mesh.triangles.empty() || !all_below(mesh, tried_planes(mesh))) return false;
  std::optional<TriangleMesh> hull = flip_hull(mesh);
  if (!hull) hull = convex_hull(mesh.positions);
  return hull && volume >= (1 - kConvexSlack) * enclosed_volume(*hull);
}

}  // namespace rigor::mesh
