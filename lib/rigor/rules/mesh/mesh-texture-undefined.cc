// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include <rigor/rules/mesh/texture.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_texture_undefined {
namespace {

// Not of visuals only: of a collision the shape is lost, too.
void check(const MeshFile& file, Context& context) {
  References undefined =
      in_state(file.facts.asset.textures, mesh::FileReference::State::kUndefined);
  const auto nameless = std::find_if(undefined.begin(), undefined.end(),
                                     [](const auto& image) { return image.written.empty(); });
  if (nameless != undefined.end()) {
    report_mesh(file, context, "an image names no file" + in_line(nameless->line));
    undefined.erase(nameless);
  }
  report_references(file, context, undefined, "a texture is not defined in the mesh file",
                    "textures are not defined in the mesh file");
}

}  // namespace

Rule rule() {
  return {
      .name = "mesh-texture-undefined",
      .category = Category::kMesh,
      .severity = Severity::kWarning,
      .summary = "a material names a texture that the file does not define",
      .why =
          "Assimp refuses the whole file, and so whoever reads Collada by it, as RViz does: "
          "\"Invalid texture, no data or file reference given\". Gazebo's own reader opens it "
          "without the picture. Found in 3 of 100 Collada files of Gazebo's models, from 3ds "
          "Max.",
      .what_to_do =
          "Write the mesh anew, without the texture: `rigor mesh-check FILE -o OUT.dae`. Or "
          "export it with its textures.",
      .bad = {{R"(<sdf version="1.9">
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
        <newparam sid="f"><surface type="2D"><init_from>skin</init_from></surface></newparam>
        <technique sid="t">
          <phong><diffuse><texture texture="f" texcoord="u"/></diffuse></phong>
        </technique>
      </profile_COMMON>
    </effect>
  </library_effects>
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
        <triangles count="4">
          <input semantic="VERTEX" source="#v" offset="0"/>
          <p>0 2 1 0 1 3 0 3 2 1 2 3</p>
        </triangles>
      </mesh>
    </geometry>
  </library_geometries>
  <library_visual_scenes>
    <visual_scene id="s">
      <node id="n">
        <instance_geometry url="#g"/>
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
        <geometry><mesh><uri>meshes/shell.dae</uri></mesh></geometry>
      </visual>
    </link>
  </model>
</sdf>
=== meshes/shell.dae
<COLLADA version="1.4.1">
  <asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>
  <library_images><image id="i"><init_from>skin.png</init_from></image></library_images>
  <library_effects>
    <effect id="e">
      <profile_COMMON>
        <newparam sid="f"><surface type="2D"><init_from>i</init_from></surface></newparam>
        <technique sid="t">
          <phong><diffuse><texture texture="f" texcoord="u"/></diffuse></phong>
        </technique>
      </profile_COMMON>
    </effect>
  </library_effects>
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
        <triangles count="4">
          <input semantic="VERTEX" source="#v" offset="0"/>
          <p>0 2 1 0 1 3 0 3 2 1 2 3</p>
        </triangles>
      </mesh>
    </geometry>
  </library_geometries>
  <library_visual_scenes>
    <visual_scene id="s">
      <node id="n">
        <instance_geometry url="#g"/>
      </node>
    </visual_scene>
  </library_visual_scenes>
  <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
=== meshes/skin.png
)"}},
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_texture_undefined
