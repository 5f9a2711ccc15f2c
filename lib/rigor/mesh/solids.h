// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The solids that a mesh is made of, each a mesh of its own.
//
//   for (const Solid& solid : solids_of(mesh)) measure(solid.mesh);

#pragma once

#include <optional>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

struct Solid {
  TriangleMesh mesh;                  ///< corners in one place are welded
  std::optional<double> volume = {};  ///< positive; of an open one unknown
};

/// Triangles that share a vertex, in the order of the first of them. What is inside out is a cavity of
/// the smallest solid whose bounds hold it, and is turned when there is none. A closed solid without a
/// volume, and degenerate triangles, are left out.
std::vector<Solid> solids_of(const TriangleMesh& mesh);

}  // namespace rigor::mesh
