// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A mesh as a thin sheet: its triangles with a wall thickness, for meshes that enclose nothing and for
// hulls of sheet metal. An approximation: right as far as the wall is thin against the mesh's bends.
//
//   Solid shell = shell_of(mesh, 0.002);
//
// Formula: a triangle of even density has the second moment A/12 (aaᵀ+bbᵀ+ccᵀ+ssᵀ), s = a+b+c (the
// area integral that belongs to polyhedron.h's volume integral).

#pragma once

#include <optional>

#include <rigor/mass/shapes.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mass {

/// `wall` in meters, above zero. Nothing when the triangles have no area.
std::optional<Solid> shell_of(const mesh::TriangleMesh& mesh, double wall);

}  // namespace rigor::mass
