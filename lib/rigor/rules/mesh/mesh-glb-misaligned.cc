// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_glb_misaligned {
namespace {

void check(const MeshFile& file, Context& context) {
  const auto& gltf = file.facts.asset.gltf;
  if (!gltf || gltf->overruns.of != mesh::GltfOverruns::Of::kChunk) return;
  report_mesh(file, context,
              fmt::format("the first chunk of the .glb has {} bytes, and is not filled up to {}",
                          gltf->overruns.held, gltf->overruns.needed));
}

}  // namespace

Rule rule() {
  return {
      .name = "mesh-glb-misaligned",
      .category = Category::kMesh,
      .severity = Severity::kError,
      .summary = "a chunk of a .glb does not end where one may",
      .why =
          "Chunks are filled up with blanks or zeros to four bytes, and assimp looks for the next "
          "one there. Of a file that is not filled up it says that it has \"no suitable reader\". "
          "Found in 2 of 31 real files, which trimesh wrote.",
      .what_to_do = "Write the mesh anew, with a newer version of what wrote it.",
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

}  // namespace rigor::rules::mesh_glb_misaligned
