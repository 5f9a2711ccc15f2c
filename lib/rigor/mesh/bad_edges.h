// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The bad edges of a mesh alone: several times faster than with all else that rings.h tells.
//
//   const std::vector<BadEdge> edges = bad_edges_of(mesh, welded);

#pragma once

#include <vector>

#include <rigor/mesh/rings.h>
#include <rigor/mesh/triangle_mesh.h>
#include <rigor/mesh/weld.h>

namespace rigor::mesh {

/// Those of `look_round`, in the same order.
std::vector<BadEdge> bad_edges_of(const TriangleMesh& mesh, const Weld& welded);

}  // namespace rigor::mesh
