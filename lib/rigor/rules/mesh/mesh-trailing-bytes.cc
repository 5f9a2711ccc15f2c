// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_trailing_bytes {
namespace {

void check(const MeshFile& file, Context& context) {
  const mesh::Fault* fault = fault_of(file, mesh::FaultKind::kTrailingBytes);
  if (fault == nullptr) return;
  report_mesh(
      file, context,
      how_many(fault->count, "byte") + " stand behind the last triangle" + in_line(fault->line));
}

}  // namespace

Rule rule() {
  return {
      .name = "mesh-trailing-bytes",
      .category = Category::kMesh,
      .severity = Severity::kError,
      .summary = "a mesh file goes on behind its last triangle",
      .why =
          "A binary STL has 84 bytes and 50 for each triangle. Assimp, MuJoCo and admesh "
          "refuse a file of another size. Mostly a tool added data of its own, or a transfer "
          "added line breaks.",
      .what_to_do = "Write the file anew: `rigor mesh-check FILE -o OUT.stl`.",
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
written by hand
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

}  // namespace rigor::rules::mesh_trailing_bytes
