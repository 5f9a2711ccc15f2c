// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Triangles that are hardly any: lines, and slivers.
//
//   if (thinness(facet(mesh, t)) == Thinness::kLine) drop(t);

#pragma once

#include <cstdint>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

enum class Thinness : std::uint8_t { kNone, kSliver, kLine };

/// Height over longest edge; below, normals and contacts of a triangle are noise (MeshLab's and
/// trimesh's thresholds lie about here; half of real robots' meshes have such triangles).
inline constexpr double kSliverRatio = 1e-3;

/// A height below the rounding of the coordinates themselves is none.
inline constexpr double kLineRoundings = 4;

Thinness thinness(const Facet& facet);

}  // namespace rigor::mesh
