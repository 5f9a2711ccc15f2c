// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Wavefront OBJ: `v` (with colors, too), `vt`, `vn`, `f` (polygons, negative indices, v/vt/vn),
// `o`, `g`, `usemtl`, `mtllib`; continued lines; any line ending. Polygons are cut into triangles
// as fans from their first corner, as consumers do. Lines, points and free-form surfaces are passed
// over and counted. An OBJ has no unit.
//
// Texture points and normals that cannot be read, or that a face names though they are not there,
// count as none: zeros.
//
//   LoadedMesh loaded = read_obj(bytes, disk, "meshes/wheel.obj");

#pragma once

#include <string>
#include <string_view>

#include <rigor/mesh/read.h>
#include <rigor/text/disk.h>

namespace rigor::mesh {

/// Of materials only the names that parts have.
LoadedMesh read_obj(std::string_view bytes);

/// With the looks of materials, from libraries in the file's folder or below. It is no fault when
/// one is missing.
LoadedMesh read_obj(std::string_view bytes, const Disk& disk, const std::string& path);

}  // namespace rigor::mesh
