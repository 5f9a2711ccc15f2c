// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_normals_missing {
namespace {

void check(const MeshFile& file, Context& context) {
  const mass::MeshFacts& facts = file.facts;
  const bool is_stl =
      facts.format == mesh::Format::kStlBinary || facts.format == mesh::Format::kStlAscii;
  if (!facts.usable() || is_stl || facts.normals || file.collision()) return;
  report_mesh(file, context, "the mesh has no normals: each viewer shades it as it thinks best");
}

}  // namespace

Rule rule() {
  return {
      .name = "mesh-normals-missing",
      .category = Category::kMesh,
      .severity = Severity::kInfo,
      .summary = "a visual mesh has no normals",
      .why =
          "Normals say whether an edge is to look sharp or round. Without them some viewers "
          "make all edges sharp, some make all round, and some draw the mesh black.",
      .what_to_do =
          "Write them: `rigor mesh-check FILE --normals 30 -o OUT.dae` makes edges of less "
          "than 30° look round.",
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
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
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
vn 0 0 -1
vn 0 -1 0
vn -1 0 0
vn 0.577 0.577 0.577
f 1//1 3//1 2//1
f 1//2 2//2 4//2
f 1//3 4//3 3//3
f 2//4 3//4 4//4
)"}},
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_normals_missing
