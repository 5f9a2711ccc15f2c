// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which closed components of a mesh lie in others: cavities, and bodies that count twice.
//
// The middle of one triangle of the inner one decides, by the number of triangles of the outer one
// above it; so components that cut each other are found by where that point lies. Bounds are compared
// first.
//
//   nest(mesh, components);
//   if (components.list[1].nesting == Nesting::kCavity) hollow();

#pragma once

#include <cstdint>

#include <rigor/mesh/topology/component.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// Triangles and pairs of components that are examined; some tenths of a second. A hundred
/// components in one another, of two thousand triangles each, are within it; what comes after is
/// `kUnknown`.
inline constexpr std::uint64_t kMaxNestingWork = 20'000'000;

void nest(const TriangleMesh& mesh, Components& components);

}  // namespace rigor::mesh
