// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/texture.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_texture_gazebo_only {
namespace {

void check(const MeshFile& file, Context& context) {
  using State = mesh::FileReference::State;
  if (!is_drawn(file)) return;
  const References& all = file.facts.asset.textures;
  References found = in_state(all, State::kTextures);
  const References urls = in_state(all, State::kUrl);
  found.insert(found.end(), urls.begin(), urls.end());
  report_references(file, context, found, "a texture is where only Gazebo looks",
                    "textures are where only Gazebo looks");
}

}  // namespace

Rule rule() {
  return {
      .name = "mesh-texture-gazebo-only",
      .category = Category::kMesh,
      .severity = Severity::kInfo,
      .summary = "a texture of a mesh is where only Gazebo looks",
      .why =
          "Gazebo looks for textures in ../materials/textures, too, and follows model: URIs "
          "inside of mesh files. RViz and others look beside the mesh only, and draw the part "
          "in one colour.",
      .what_to_do =
          "Write the path from the mesh to the picture into the mesh file, such as "
          "../materials/textures/skin.png, which everyone finds.",
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
map_Kd skin.png
=== materials/textures/skin.png
)"},
              {R"(<sdf version="1.9">
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
map_Kd model://part/materials/textures/skin.png
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
map_Kd ../materials/textures/skin.png
=== materials/textures/skin.png
)"}},
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_texture_gazebo_only
