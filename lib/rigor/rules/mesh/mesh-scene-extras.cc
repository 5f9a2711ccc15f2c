// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_scene_extras {
namespace {

void check(const MeshFile& file, Context& context) {
  const auto& collada = file.facts.asset.collada;
  if (file.use != nullptr || !collada) return;
  std::string found;
  const auto add = [&found](const mesh::Sighting& sighting, std::string_view one) {
    if (sighting.count == 0) return;
    found += (found.empty() ? "" : ", ") + how_many(sighting.count, one) + in_line(sighting.first);
  };
  add(collada->cameras, "camera");
  add(collada->lights, "light");
  add(collada->animations, "animation");
  add(collada->controllers, "controller");
  if (!found.empty()) report_mesh(file, context, "the scene also holds " + found);
}

}  // namespace

Rule rule() {
  return {
      .name = "mesh-scene-extras",
      .category = Category::kMesh,
      .severity = Severity::kInfo,
      .summary = "a mesh file holds cameras, lights or animations",
      .why =
          "Robots do without: Gazebo takes some of it, as animations of actors, RViz none. "
          "Told of a file that is checked by itself only.",
      .what_to_do =
          "Leave them out when exporting, or write the mesh alone: `rigor mesh-check FILE -o "
          "OUT.dae`.",
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

}  // namespace rigor::rules::mesh_scene_extras
