// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures whose bytes a material has from the mesh's own file, where that is to be written in a
// format that only names pictures: they become files beside it.
//
//   NamedPictures named = named_pictures(mesh.materials, "arm");
//   mesh.materials = named.materials;  // "arm-1.png" is the texture of the first that holds one

#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>
#include <rigor/mesh/write/write.h>

namespace rigor::mesh {

enum class PictureKind : std::uint8_t { kNone, kPng, kJpeg, kOther };

/// By the first bytes. `kNone` where there are none.
PictureKind kind_of(const std::shared_ptr<const std::string>& picture);

struct NamedPictures {
  std::vector<Material> materials;
  std::vector<SideFile> files;  ///< each picture once
};

/// Files are named `stem`-1.png, `stem`-2.jpg and so on. What is neither is left out.
NamedPictures named_pictures(std::vector<Material> materials, const std::string& stem);

}  // namespace rigor::mesh
