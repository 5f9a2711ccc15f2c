// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_no_endsolid {
namespace {

void check(const MeshFile& file, Context& context) {
  if (fault_of(file, mesh::FaultKind::kNoEndsolid) == nullptr) return;
  if (fault_of(file, mesh::FaultKind::kTruncated) != nullptr) return;  // that tells more
  report_mesh(file, context, "the STL ends without the word endsolid");
}

}  // namespace

Rule rule() {
  return {
      .name = "mesh-no-endsolid",
      .category = Category::kMesh,
      .severity = Severity::kInfo,
      .summary = "an STL in text ends without endsolid",
      .why =
          "Something may be missing at its end. RViz tells text from binary by that word, and "
          "reads the file as a binary one.",
      .what_to_do =
          "Export the mesh again if something is missing; else write it anew: `rigor "
          "mesh-check FILE -o OUT.stl`.",
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
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="part">
    <static>true</static>
    <link name="body">
      <visual name="shell">
        <geometry><mesh><uri>meshes/shell.stl</uri></mesh></geometry>
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
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_no_endsolid
