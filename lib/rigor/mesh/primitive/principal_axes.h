// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a closed mesh encloses, and the directions it is long and short in.
//
//   const Enclosed inside = enclosed(hull);
//   const auto axes = principal_axes(inside.spread);

#pragma once

#include <array>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

struct Enclosed {
  double volume = 0;  ///< negative when the mesh is wound inside out
  Vector3 center;
  model::Matrix3 spread{};  ///< ∫ (p - center)(p - center)ᵀ dV
};

/// Formulas as in mass/polyhedron.h, about the first position. Without a volume, all is zero but the
/// volume.
Enclosed enclosed(const TriangleMesh& mesh);

double enclosed_volume(const TriangleMesh& mesh);

/// Orthonormal eigenvectors of a symmetric matrix, of the greatest eigenvalue first (Jacobi's method).
std::array<Vector3, 3> principal_axes(const model::Matrix3& symmetric);

}  // namespace rigor::mesh
