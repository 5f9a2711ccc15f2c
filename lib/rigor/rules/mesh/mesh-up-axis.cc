// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_up_axis {
namespace {

void check(const MeshFile& file, Context& context) {
  using Up = mesh::ColladaFacts::Up;
  const auto& collada = file.facts.asset.collada;
  if (!collada || (collada->up_axis != Up::kX && collada->up_axis != Up::kY)) return;
  report_mesh(file, context,
              "the Collada file says that " + std::string(collada->up_axis == Up::kX ? "X" : "Y") +
                  " points up, which some programs heed and some do not" +
                  in_line(collada->up_axis_line));
}

}  // namespace

Rule rule() {
  return {
      .name = "mesh-up-axis",
      .category = Category::kMesh,
      .severity = Severity::kInfo,
      .summary = "a Collada file says that another axis than Z points up",
      .why =
          "Gazebo and RViz pass over <up_axis> and take the coordinates as they are; assimp by "
          "itself, three.js and OpenSceneGraph turn the mesh. So it lies on its side in one of "
          "them.",
      .what_to_do =
          "Look at it in the simulator that counts. Where it stands upright, write it anew, "
          "`rigor mesh-check FILE -o OUT.dae`: then Z is up for all. Where it lies, add `--up "
          "y`, which turns it.",
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
  <asset><unit name="meter" meter="1"/><up_axis>Y_UP</up_axis></asset>
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

}  // namespace rigor::rules::mesh_up_axis
