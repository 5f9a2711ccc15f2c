// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_unit_missing {
namespace {

void check(const MeshFile& file, Context& context) {
  const auto& collada = file.facts.asset.collada;
  if (!collada || collada->unit_line > 0) return;
  report_mesh(file, context, "the Collada file names no unit: its lengths are taken for metres");
}

}  // namespace

Rule rule() {
  return {
      .name = "mesh-unit-missing",
      .category = Category::kMesh,
      .severity = Severity::kInfo,
      .summary = "a Collada file names no unit",
      .why =
          "Without a <unit> its lengths are metres, by Collada's definition. Whether they were "
          "meant so nobody can tell: a third of the Collada files of some robots has none.",
      .what_to_do =
          "Look at the size, and say what a unit is: `rigor mesh-check FILE --unit mm -o "
          "OUT.dae` writes metres and says so.",
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
  <asset><up_axis>Z_UP</up_axis></asset>
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
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_unit_missing
