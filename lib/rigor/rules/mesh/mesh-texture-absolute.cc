// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/texture.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_texture_absolute {
namespace {

void check(const MeshFile& file, Context& context) {
  if (!is_drawn(file)) return;
  report_references(file, context,
                    in_state(file.facts.asset.textures, mesh::FileReference::State::kAbsolute),
                    "a texture has an absolute path", "textures have absolute paths");
}

}  // namespace

Rule rule() {
  return {
      .name = "mesh-texture-absolute",
      .category = Category::kMesh,
      .severity = Severity::kWarning,
      .summary = "a texture has an absolute path",
      .why =
          "The path is that of the machine where the mesh was made. On any other the picture "
          "is not found.",
      .what_to_do = "Put the picture beside the mesh, and export it with relative paths.",
      .bad = {{R"(<sdf version="1.9">
  <model name="part">
    <static>true</static>
    <link name="body">
      <visual name="shell">
        <geometry><mesh><uri>«meshes/shell.obj»</uri></mesh></geometry>
      </visual>
    </link>
  </model>
</sdf>
=== meshes/shell.obj
mtllib shell.mtl
usemtl skin
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
vn 0 0 -1
vn 0 -1 0
vn -1 0 0
vn 0.577 0.577 0.577
f 1//1 3//1 2//1
f 1//2 2//2 4//2
f 1//3 4//3 3//3
f 2//4 3//4 4//4
=== meshes/shell.mtl
newmtl skin
map_Kd C:\Users\ann\skin.png
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="part">
    <static>true</static>
    <link name="body">
      <visual name="shell">
        <geometry><mesh><uri>meshes/shell.obj</uri></mesh></geometry>
      </visual>
    </link>
  </model>
</sdf>
=== meshes/shell.obj
mtllib shell.mtl
usemtl skin
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
vn 0 0 -1
vn 0 -1 0
vn -1 0 0
vn 0.577 0.577 0.577
f 1//1 3//1 2//1
f 1//2 2//2 4//2
f 1//3 4//3 3//3
f 2//4 3//4 4//4
=== meshes/shell.mtl
newmtl skin
map_Kd skin.png
=== meshes/skin.png
)"}},
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_texture_absolute
