// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>
#include <string>

#include <fmt/core.h>

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_buffer_too_short {
namespace {

std::string first_overrun(const mesh::GltfOverruns& overruns) {
  using Of = mesh::GltfOverruns::Of;
  const auto& [count, of, index, needed, held] = overruns;
  switch (of) {
    case Of::kBuffer: return fmt::format("buffer {} has {} bytes of {}", index, held, needed);
    case Of::kView:
      return fmt::format("buffer view {} reaches to byte {} of a buffer of {}", index, needed,
                         held);
    case Of::kAccessor:
      return fmt::format("accessor {} reaches to byte {} of a buffer view of {}", index, needed,
                         held);
    case Of::kChunk: break;  // has a rule of its own
  }
  return {};
}

void check(const MeshFile& file, Context& context) {
  const auto& gltf = file.facts.asset.gltf;
  if (!gltf || gltf->overruns.count == 0) return;
  const std::string first = first_overrun(gltf->overruns);
  if (first.empty()) return;
  const std::uint64_t more = gltf->overruns.count - 1;
  const std::string others = more == 0 ? "" : fmt::format(", and {} more are too short", more);
  report_mesh(file, context, first + others);
}

}  // namespace

Rule rule() {
  return {
      .name = "mesh-buffer-too-short",
      .category = Category::kMesh,
      .severity = Severity::kError,
      .summary = "a glTF file names more bytes than there are",
      .why =
          "Accessors lie in buffer views, and those in buffers. Of one that reaches beyond its "
          "end assimp reads nothing and refuses the whole mesh: \"out of range\". Mostly the file "
          "was cut when it was copied, or its buffer is of another export.",
      .what_to_do = "Copy the mesh and its buffers again, or export it anew.",
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
  "scene": 0,
  "scenes": [{"nodes": [0]}],
  "nodes": [{"mesh": 0}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 1}, "indices": 0}]}],
  "accessors": [
    {"bufferView": 0, "componentType": 5123, "count": 12, "type": "SCALAR"},
    {"bufferView": 1, "componentType": 5126, "count": 40, "type": "VEC3",
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
)"},
              {R"(<sdf version="1.9">
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
    {"byteLength": 720, "uri": "data:application/octet-stream;base64,AAACAAEAAAABAAMAAAADAAIAAQACAAMAAAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/"}
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

}  // namespace rigor::rules::mesh_buffer_too_short
