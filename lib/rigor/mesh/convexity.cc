// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/convexity.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <rigor/mesh/hull.h>
#include <rigor/mesh/principal_axes.h>

namespace rigor::mesh {
namespace {

// Triangles whose plane is tried. Of a mesh with a dent of a hundredth of its surface one of them
// lies there nearly always.
constexpr std::size_t kTried = 200;

// Multiples of it fall into [0, 1) evenly, and not in step with the rows of a grid.
constexpr double kGoldenRatio = 0.6180339887498949;

// Height above a plane that is none, as a share of the diagonal: rounding of 32-bit coordinates.
constexpr double kFlat = 1e-5;

bool all_below(const TriangleMesh& mesh, const Facet& f, double slack) {
  const Vector3 normal = model::cross(f[1] - f[0], f[2] - f[0]);
  const double limit = model::dot(normal, f[0]) + slack * model::length(normal);
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
    return model::dot(normal, mesh.positions[t[0]]) <= limit;
  });
}

}  // namespace

bool is_convex(const TriangleMesh& mesh, double volume) {
  if (mesh.triangles.empty()) return false;
  const double slack = kFlat * diagonal(bounds_of(mesh.positions));
  for (std::size_t i = 1; i <= kTried; ++i) {
    const double at = std::fmod(static_cast<double>(i) * kGoldenRatio, 1.0);
    const auto face = static_cast<std::size_t>(at * static_cast<double>(mesh.triangles.size()));
    if (!all_below(mesh, facet(mesh, mesh.triangles[face]), slack)) return false;
  }
  const auto hull = convex_hull(mesh.positions);
  return hull && volume >= (1 - kConvexSlack) * enclosed_volume(*hull);
}

}  // namespace rigor::mesh
