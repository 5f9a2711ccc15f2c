// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The bad edges of a mesh alone: several times faster than with all else that rings.h tells.
//
//   const std::vector<BadEdge> edges = bad_edges_of(mesh, welded);

#pragma once

#include <cstdint>
#include <vector>

#include <rigor/mesh/topology/rings.h>
#include <rigor/mesh/topology/weld.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// Those of `look_round`, in the same order.
std::vector<BadEdge> bad_edges_of(const TriangleMesh& mesh, const Weld& welded);

/// Of those, the ones that end at one of these places; and, where asked for, at least all that have more
/// triangles one way than the other: so all boundary and all inconsistent edges. Faster for few.
std::vector<BadEdge> bad_edges_at(const TriangleMesh& mesh, const Weld& welded,
                                  const std::vector<std::uint32_t>& places, bool and_open);

}  // namespace rigor::mesh
