// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/image/picture_names.h>

#include <algorithm>

#include <rigor/text/path.h>

namespace rigor::mesh {
namespace {

/// Some readers hand on a URI decoded, some as it is written.
bool is_named(const FileReference& texture, const std::string& name) {
  return is_there(texture) && (texture.written == name || percent_decoded(texture.written) == name);
}

}  // namespace

std::vector<Material> materials_at(const std::string& path, std::vector<Material> materials,
                                   const std::vector<FileReference>& textures) {
  const std::string_view folder = parent_path(path);
  for (Material& material : materials) {
    if (material.texture.empty()) continue;
    const auto found = std::find_if(
        textures.begin(), textures.end(),
        [&](const FileReference& texture) { return is_named(texture, material.texture); });
    if (found == textures.end()) continue;
    const std::string picture = normalize_path(found->path);
    if (join_path(folder, material.texture) != picture) {
      material.texture = relative_path(folder, picture);
    }
  }
  return materials;
}

}  // namespace rigor::mesh
