// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/texture.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_material_undefined {
namespace {

void check(const MeshFile& file, Context& context) {
  if (!is_drawn(file)) return;
  References undefined;
  for (const mesh::Mention& material : file.facts.asset.undefined_materials) {
    undefined.push_back({.written = material.name, .line = material.line});
  }
  report_references(file, context, undefined, "a material is not defined",
                    "materials are not defined");
}

}  // namespace

Rule rule() {
  return {
      .name = "mesh-material-undefined",
      .category = Category::kMesh,
      .severity = Severity::kWarning,
      .summary = "triangles of a mesh have a material that no file defines",
      .why =
          "They are drawn in the colour that a program has for what it knows nothing of, mostly "
          "grey. In an OBJ a material is defined (newmtl) by the library that mtllib names; the "
          "triangles of a Collada file have a symbol, which an instance of their geometry binds "
          "to a material.",
      .what_to_do =
          "Define the material, name the library that does, or export the mesh with its "
          "materials.",
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
newmtl steel
Kd 0.5 0.5 0.6
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
)"},
              {R"(<sdf version="1.9">
  <model name="part">
    <static>true</static>
    <link name="body">
      <visual name="shell">
        <geometry><mesh><uri>«meshes/shell.dae»</uri></mesh></geometry>
      </visual>
    </link>
  </model>
</sdf>
=== meshes/shell.dae
<COLLADA version="1.4.1">
  <asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>
  <library_effects>
    <effect id="e">
      <profile_COMMON>
        <technique sid="t"><phong><diffuse><color>1 0 0 1</color></diffuse></phong></technique>
      </profile_COMMON>
    </effect>
  </library_effects>
  <library_materials><material id="red"><instance_effect url="#e"/></material></library_materials>
  <library_geometries>
    <geometry id="g">
      <mesh>
        <source id="p">
          <float_array id="a" count="12">0 0 0 1 0 0 0 1 0 0 0 1</float_array>
          <technique_common>
            <accessor source="#a" count="4" stride="3">
              <param name="X" type="float"/>
              <param name="Y" type="float"/>
              <param name="Z" type="float"/>
            </accessor>
          </technique_common>
        </source>
        <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
        <triangles count="4" material="skin">
          <input semantic="VERTEX" source="#v" offset="0"/>
          <p>0 2 1 0 1 3 0 3 2 1 2 3</p>
        </triangles>
      </mesh>
    </geometry>
  </library_geometries>
  <library_visual_scenes>
    <visual_scene id="s">
      <node id="n">
        <instance_geometry url="#g">
          <bind_material>
            <technique_common>
              <instance_material symbol="skin" target="#blue"/>
            </technique_common>
          </bind_material>
        </instance_geometry>
      </node>
    </visual_scene>
  </library_visual_scenes>
  <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
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
Kd 0.5 0.5 0.6
)"},
               {R"(<sdf version="1.9">
  <model name="part">
    <static>true</static>
    <link name="body">
      <visual name="shell">
        <geometry><mesh><uri>meshes/shell.dae</uri></mesh></geometry>
      </visual>
    </link>
  </model>
</sdf>
=== meshes/shell.dae
<COLLADA version="1.4.1">
  <asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>
  <library_effects>
    <effect id="e">
      <profile_COMMON>
        <technique sid="t"><phong><diffuse><color>1 0 0 1</color></diffuse></phong></technique>
      </profile_COMMON>
    </effect>
  </library_effects>
  <library_materials><material id="red"><instance_effect url="#e"/></material></library_materials>
  <library_geometries>
    <geometry id="g">
      <mesh>
        <source id="p">
          <float_array id="a" count="12">0 0 0 1 0 0 0 1 0 0 0 1</float_array>
          <technique_common>
            <accessor source="#a" count="4" stride="3">
              <param name="X" type="float"/>
              <param name="Y" type="float"/>
              <param name="Z" type="float"/>
            </accessor>
          </technique_common>
        </source>
        <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
        <triangles count="4" material="skin">
          <input semantic="VERTEX" source="#v" offset="0"/>
          <p>0 2 1 0 1 3 0 3 2 1 2 3</p>
        </triangles>
      </mesh>
    </geometry>
  </library_geometries>
  <library_visual_scenes>
    <visual_scene id="s">
      <node id="n">
        <instance_geometry url="#g">
          <bind_material>
            <technique_common>
              <instance_material symbol="skin" target="#red"/>
            </technique_common>
          </bind_material>
        </instance_geometry>
      </node>
    </visual_scene>
  </library_visual_scenes>
  <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
)"}},
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_material_undefined
