// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A coarse mesh nearer to the surface that it stands for. A reduced mesh has corners of the original alone, so it lies
// inside of what bulges and outside of what is hollow; with corners beside the surface the same triangles are about
// half as far off.
//
//   TriangleMesh near = fitted(reduce(mesh, {.triangles = 100}).mesh, mesh);

#pragma once

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// The same triangles with corners moved; as it is where no move that was tried brings it nearer. Positions in one place
/// are to be one. What is as near as `enough`, in the meshes' unit, is not moved on.
TriangleMesh fitted(TriangleMesh coarse, const TriangleMesh& fine, double enough = 0);

}  // namespace rigor::mesh
