// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <string_view>

#include <rigor/rules/mesh/gltf.h>
#include <rigor/rules/mesh/texture.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_extension_rare {

constexpr std::array<std::string_view, 1> kPacked{"KHR_draco_mesh_compression"};
constexpr std::array<std::string_view, 4> kPictures{"KHR_texture_basisu", "EXT_texture_webp",
                                                    "EXT_texture_avif", "MSFT_texture_dds"};

void check(const MeshFile& file, Context& context) {
  References required = required_of(file, kPacked);
  if (is_drawn(file)) {
    const References pictures = required_of(file, kPictures);
    required.insert(required.end(), pictures.begin(), pictures.end());
  }
  report_references(file, context, required,
                    "the mesh needs an extension of glTF that few readers know",
                    "extensions of glTF that few readers know are needed");
}

Rule rule() {
  return {
      .name = "mesh-extension-rare",
      .severity = Severity::kWarning,
      .summary = "a glTF file needs an extension that few readers know",
      .why = "Triangles packed with Draco are read only by an assimp that was built with it, which "
             "it is not by default: the others refuse the mesh. Of pictures as KTX 2, WebP, AVIF "
             "or DDS the part is seen, in one colour.",
      .what_to_do = "Export the mesh without Draco, and its pictures as PNG or JPEG.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_extension_rare
