// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>

#include <rigor/rules/mesh/texture.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_texture_missing {
namespace {

/// Gazebo draws a visual that has a <material> of its own with that, whatever the mesh says. RViz
/// takes a URDF's material only for meshes without any.
bool painted_over(const MeshFile& file, Context& context) {
  if (!context.is_sdf() || !file.use) return false;
  std::optional<xml::Element> at = context.element(file.use->geometry.site);
  while (at && at->name() != "visual") at = at->parent();
  return at && at->child("material").has_value();
}

void check(const MeshFile& file, Context& context) {
  if (!is_drawn(file) || painted_over(file, context)) return;
  report_references(file, context,
                    in_state(file.facts.asset.textures, mesh::FileReference::State::kMissing),
                    "a texture is not found", "textures are not found");
}

}  // namespace

Rule rule() {
  return {
      .name = "mesh-texture-missing",
      .category = Category::kMesh,
      .severity = Severity::kWarning,
      .summary = "a texture of a mesh is not found",
      .why =
          "The part is drawn in one colour, often white or black. Names are looked for beside "
          "the file that names them; Gazebo looks in ../materials/textures, too.",
      .what_to_do =
          "Put the picture where the mesh says it is, or export the mesh with the right path.",
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
)"},
               {R"(<sdf version="1.9">
  <model name="part">
    <static>true</static>
    <link name="body">
      <visual name="shell">
        <geometry><mesh><uri>meshes/shell.obj</uri></mesh></geometry>
        <material><diffuse>1 0 0</diffuse></material>
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
)"}},
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_texture_missing
