// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Components of a mesh that are tiny beside the whole: crumbs of modeling and scanning.
//
//   gone = drop_specks(mesh, 1e-3);

#pragma once

#include <cstdint>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// Takes away components whose box has a diagonal below this share of the whole mesh's, but not the
/// largest one. Returns how many are gone.
std::uint64_t drop_specks(TriangleMesh& mesh, double share);

}  // namespace rigor::mesh
