// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_index_out_of_range {
namespace {

void check(const MeshFile& file, Context& context) {
  const mesh::Fault* fault = fault_of(file, mesh::FaultKind::kIndexOutOfRange);
  if (fault == nullptr) return;
  report_mesh(file, context,
              fault->count > 0 ? how_many(fault->count, "corner") + " of faces name" +
                                     (fault->count == 1 ? "s" : "") +
                                     " a vertex that there is not" + in_line(fault->line)
                               : "a face names a vertex that there is not");
}

}  // namespace

Rule rule() {
  return {
      .name = "mesh-index-out-of-range",
      .category = Category::kMesh,
      .severity = Severity::kError,
      .summary = "a face names a vertex that there is not",
      .why =
          "Assimp refuses the whole mesh; a reader that does not look reads what lies behind "
          "its memory.",
      .what_to_do = "Export the mesh again: vertices are missing, or faces of another mesh got in.",
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
f 2 3 5
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

}  // namespace rigor::rules::mesh_index_out_of_range
