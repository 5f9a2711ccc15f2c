// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A scene of assimp's as plain triangles: transforms applied, polygons cut into fans from their
// first corner, instanced meshes repeated, one part for each mesh of each node. Of what vertices
// carry, the first channels of texture coordinates and colors are kept, and normals; of materials
// the diffuse color and picture, unless that is inside the file. Calls nothing of the library.
//
//   LoadedMesh loaded = bake(*scene);

#pragma once

#include <rigor/mesh/read.h>

struct aiScene;

namespace rigor::mesh {

LoadedMesh bake(const aiScene& scene);

}  // namespace rigor::mesh
