// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_ascii_stl {
namespace {

void check(const MeshFile& file, Context& context) {
  if (!file.facts.usable() || file.facts.format != mesh::Format::kStlAscii) return;
  report_mesh(file, context, "the STL is written as text: RViz and MuJoCo read binary ones only");
}

}  // namespace

Rule rule() {
  return {
      .name = "mesh-ascii-stl",
      .category = Category::kMesh,
      .severity = Severity::kWarning,
      .summary = "an STL is written as text",
      .why =
          "RViz (\"can only load binary STL files\") and MuJoCo refuse it; Gazebo reads it. It "
          "is also about five times the size of a binary one, and takes as much longer to "
          "read.",
      .what_to_do = "Write it as a binary one: `rigor mesh-check FILE -o OUT.stl`.",
      .bad = {{R"(<sdf version="1.9">
  <model name="part">
    <static>true</static>
    <link name="body">
      <visual name="shell">
        <geometry><mesh><uri>«meshes/shell.stl»</uri></mesh></geometry>
      </visual>
    </link>
  </model>
</sdf>
=== meshes/shell.stl
solid shell
facet normal 0 0 0
outer loop
vertex 0 0 0
vertex 0 1 0
vertex 1 0 0
endloop
endfacet
facet normal 0 0 0
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 0 1
endloop
endfacet
facet normal 0 0 0
outer loop
vertex 0 0 0
vertex 0 0 1
vertex 0 1 0
endloop
endfacet
facet normal 0 0 0
outer loop
vertex 1 0 0
vertex 0 1 0
vertex 0 0 1
endloop
endfacet
endsolid shell
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
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
)"}},
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_ascii_stl
