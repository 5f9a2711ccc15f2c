// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/shell.h>

#include <cmath>

namespace rigor::mass {
namespace {

using model::Vector3;

/// What a body of mass m at p adds to ∫ p pᵀ, as the inertia m (|p|² 1 - p pᵀ).
Inertia spread_inertia(const mesh::Facet& f, double area) {
  const Vector3 s = f[0] + f[1] + f[2];
  const double share = area / 12;
  return point_inertia(share, f[0]) + point_inertia(share, f[1]) + point_inertia(share, f[2]) +
         point_inertia(share, s);
}

}  // namespace

std::optional<Solid> shell_of(const mesh::TriangleMesh& mesh, double wall) {
  if (mesh.triangles.empty()) return std::nullopt;
  const Vector3 reference = mesh.positions[mesh.triangles.front()[0]];
  double area = 0;
  Vector3 first;
  Inertia about_reference;
  for (const mesh::Triangle& t : mesh.triangles) {
    mesh::Facet f = mesh::facet(mesh, t);
    for (Vector3& corner : f) corner = corner - reference;
    const double own = mesh::area(f);
    area += own;
    first = first + (own / 3) * (f[0] + f[1] + f[2]);
    about_reference = about_reference + spread_inertia(f, own);
  }
  if (!(area > 0) || !std::isfinite(area)) return std::nullopt;
  const Vector3 com = (1 / area) * first;
  const Inertia unit = (1 / area) * about_reference - point_inertia(1, com);
  return Solid{area * wall, reference + com, unit};
}

}  // namespace rigor::mass
