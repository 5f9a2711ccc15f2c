// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Wavefront OBJ: `v`, `f` (polygons, negative indices, v/vt/vn), `o`, `g`, `usemtl`; continued lines;
// any line ending. Polygons are cut into triangles as fans from their first corner, as consumers do.
// Lines, points and free-form surfaces are passed over and counted. An OBJ has no unit.
//
//   LoadedMesh loaded = read_obj(bytes);

#pragma once

#include <string_view>

#include <rigor/mesh/read.h>

namespace rigor::mesh {

LoadedMesh read_obj(std::string_view bytes);

}  // namespace rigor::mesh
