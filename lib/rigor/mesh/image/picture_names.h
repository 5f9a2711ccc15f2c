// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A mesh that is written to another folder must name its pictures anew: they stay where they are, and
// what was "skin.png" becomes "../meshes/skin.png". No picture is copied, so none is overwritten.
//
//   const Asset asset = asset_of(disk, "/robot/meshes/arm.dae", Format::kCollada);
//   mesh.materials = materials_at("/robot/collision/arm.obj", mesh.materials, asset.textures);

#pragma once

#include <string>
#include <vector>

#include <rigor/mesh/asset/file_reference.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// The materials as a file at `path` has to write them. `textures` are what the mesh's own file names,
/// seen from where `path` is seen from. What is not there keeps its name, and so does what the
/// new file finds by it.
std::vector<Material> materials_at(const std::string& path, std::vector<Material> materials,
                                   const std::vector<FileReference>& textures);

}  // namespace rigor::mesh
