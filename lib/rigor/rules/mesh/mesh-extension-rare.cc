// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <string_view>

#include <rigor/rules/mesh/gltf.h>
#include <rigor/rules/mesh/texture.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_extension_rare {
namespace {

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

}  // namespace

Rule rule() {
  return {
      .name = "mesh-extension-rare",
      .category = Category::kMesh,
      .severity = Severity::kWarning,
      .summary = "a glTF file needs an extension that few readers know",
      .why =
          "Triangles packed with Draco are read only by an assimp that was built with it, which "
          "it is not by default: the others refuse the mesh. Of pictures as KTX 2, WebP, AVIF "
          "or DDS the part is seen, in one colour.",
      .what_to_do = "Export the mesh without Draco, and its pictures as PNG or JPEG.",
      .bad = {{R"(<sdf version="1.9">
  <model name="part">
    <static>true</static>
    <link name="body">
      <visual name="shell">
        <geometry><mesh><uri>«meshes/shell.gltf»</uri></mesh></geometry>
      </visual>
    </link>
  </model>
</sdf>
=== meshes/shell.gltf
{
  "asset": {"version": "2.0"},
  "extensionsUsed": ["KHR_texture_basisu"],
  "extensionsRequired": ["KHR_texture_basisu"],
  "scene": 0,
  "scenes": [{"nodes": [0]}],
  "nodes": [{"mesh": 0}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 1}, "indices": 0}]}],
  "accessors": [
    {"bufferView": 0, "componentType": 5123, "count": 12, "type": "SCALAR"},
    {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC3",
     "min": [0, 0, 0], "max": [1, 1, 1]}
  ],
  "bufferViews": [
    {"buffer": 0, "byteLength": 24},
    {"buffer": 0, "byteOffset": 24, "byteLength": 48}
  ],
  "buffers": [
    {"byteLength": 72, "uri": "data:application/octet-stream;base64,AAACAAEAAAABAAMAAAADAAIAAQACAAMAAAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/"}
  ]
}
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="part">
    <static>true</static>
    <link name="body">
      <visual name="shell">
        <geometry><mesh><uri>meshes/shell.gltf</uri></mesh></geometry>
      </visual>
    </link>
  </model>
</sdf>
=== meshes/shell.gltf
{
  "asset": {"version": "2.0"},
  "extensionsUsed": ["KHR_draco_mesh_compression"],
  "scene": 0,
  "scenes": [{"nodes": [0]}],
  "nodes": [{"mesh": 0}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 1}, "indices": 0}]}],
  "accessors": [
    {"bufferView": 0, "componentType": 5123, "count": 12, "type": "SCALAR"},
    {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC3",
     "min": [0, 0, 0], "max": [1, 1, 1]}
  ],
  "bufferViews": [
    {"buffer": 0, "byteLength": 24},
    {"buffer": 0, "byteOffset": 24, "byteLength": 48}
  ],
  "buffers": [
    {"byteLength": 72, "uri": "data:application/octet-stream;base64,AAACAAEAAAABAAMAAAADAAIAAQACAAMAAAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/"}
  ]
}
)"}},
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_extension_rare
