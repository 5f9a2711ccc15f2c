// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <vector>

#include <fmt/core.h>

#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_inverted {
namespace {

/// A mirroring scale turns the mesh round once more.
bool mirrored(const MeshFile& file) {
  const auto [x, y, z] = file.scale();
  return x * y * z < 0;
}

/// What a mirroring node turns round depends on the reader: `mesh-mirrored-node`.
bool has_mirrored_node(const MeshFile& file) {
  const auto& collada = file.facts.asset.collada;
  return collada && collada->mirrored_nodes.count > 0;
}

void check(const MeshFile& file, Context& context) {
  const mass::MeshShape* shape = shape_of(file);
  if (!shape) return;
  const mesh::Topology& topology = shape->topology;
  if (topology.inverted == 0 || mirrored(file) || has_mirrored_node(file)) return;
  if (topology.components == 1) {
    report_mesh(
        file, context,
        "the mesh is inside out: its triangles face inward, so that its volume is negative");
    return;
  }
  std::vector<model::Vector3> places;
  for (const mesh::Component& component : topology.component_list) {
    if (component.inverted()) places.push_back(middle(component.bounds));
  }
  report_mesh(file, context,
              fmt::format("{} of {} separate pieces of the mesh {} inside out{}", topology.inverted,
                          topology.components, topology.inverted == 1 ? "is" : "are",
                          at_places(places, topology.inverted)));
}

}  // namespace

Rule rule() {
  return {
      .name = "mesh-inverted",
      .category = Category::kMesh,
      .severity = Severity::kWarning,
      .summary = "a closed mesh is inside out",
      .why =
          "All its triangles face inward. Its volume is negative, which MuJoCo, Drake and "
          "Gazebo's automatic inertia reject or turn into a wrong mass; viewers that cull back "
          "faces show its inside.",
      .what_to_do =
          "Turn its triangles round: `rigor mesh-check FILE --repair -o OUT`, or \"flip normals\" "
          "in the tool that made it.",
      .bad = {{R"(<sdf version="1.9">
  <model name="part">
    <static>true</static>
    <link name="body">
      <collision name="shell">
        <geometry><mesh><uri>«meshes/shell.obj»</uri></mesh></geometry>
      </collision>
    </link>
  </model>
</sdf>
=== meshes/shell.obj
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
f 1 2 3
f 1 4 2
f 1 3 4
f 2 4 3
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="part">
    <static>true</static>
    <link name="body">
      <collision name="shell">
        <geometry><mesh><uri>meshes/shell.obj</uri></mesh></geometry>
      </collision>
    </link>
  </model>
</sdf>
=== meshes/shell.obj
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
)"},
               // Faces inward, and its node mirrors it: right side out if nobody turns it back.
               {R"(<sdf version="1.9">
  <model name="part">
    <static>true</static>
    <link name="body">
      <collision name="shell">
        <geometry><mesh><uri>meshes/shell.dae</uri></mesh></geometry>
      </collision>
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
          <p>0 1 2 0 3 1 0 2 3 1 3 2</p>
        </triangles>
      </mesh>
    </geometry>
  </library_geometries>
  <library_visual_scenes>
    <visual_scene id="s">
      <node id="n"><scale>-1 1 1</scale>
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

}  // namespace rigor::rules::mesh_inverted
