// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/write/losses.h>

#include <algorithm>
#include <set>

#include <rigor/mesh/image/embedded_pictures.h>
#include <rigor/text/path.h>

namespace rigor::mesh {
namespace {

bool see_through(const Corners& corners) {
  return std::any_of(corners.colors.begin(), corners.colors.end(), [](const auto& triangle) {
    return std::any_of(triangle.begin(), triangle.end(),
                       [](const Corners::Color& color) { return color[3] != 1; });
  });
}

/// Readers hand on a URI decoded or as it is written.
bool is_color(const FileReference& picture, const std::vector<Material>& materials) {
  return std::any_of(materials.begin(), materials.end(), [&picture](const Material& material) {
    return material.texture == picture.written ||
           material.texture == percent_decoded(picture.written);
  });
}

}  // namespace

std::vector<std::string> losses(const TriangleMesh& mesh, std::string_view path,
                                const std::vector<FileReference>& textures) {
  const std::string ending = extension(path);
  const bool shape_alone = ending == ".stl";
  const bool no_materials = shape_alone || ending == ".ply";
  std::vector<std::string> lost;
  const auto lose = [&lost](bool is, const char* what) {
    if (is) lost.emplace_back(what);
  };
  lose(no_materials && mesh.parts.size() > 1, "the division into parts");
  lose(no_materials && !mesh.materials.empty(), "materials");
  lose(shape_alone && !mesh.corners.texture.empty(), "texture points");
  lose(shape_alone && !mesh.corners.colors.empty(), "colors of vertices");
  lose(ending == ".obj" && see_through(mesh.corners), "the opacity of vertices");
  if (no_materials || mesh.materials.empty()) return lost;
  const bool unknown = std::any_of(
      mesh.materials.begin(), mesh.materials.end(),
      [](const Material& m) { return kind_of(m.embedded_picture) == PictureKind::kOther; });
  lose(unknown, "images that are neither PNG nor JPEG");
  std::set<std::string> told;
  for (const FileReference& picture : textures) {
    const bool held = picture.state == FileReference::State::kEmbedded || picture.written.empty();
    if (held || is_color(picture, mesh.materials) || !told.insert(picture.written).second) continue;
    lost.push_back("the image " + picture.written);
  }
  return lost;
}

}  // namespace rigor::mesh
