// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a mesh carries and a file of some format does not (the tables of write.h), to be told to whoever
// converts it.
//
//   for (const std::string& lost : losses(mesh, "arm.stl", asset.textures)) say(lost);

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <rigor/mesh/asset/file_reference.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// "texture points", "the image bumps.png". `textures` are what the mesh's own file names: those
/// that are no surface's color (normals, roughness, shine) are in no material.
std::vector<std::string> losses(const TriangleMesh& mesh, std::string_view path,
                                const std::vector<FileReference>& textures);

}  // namespace rigor::mesh
