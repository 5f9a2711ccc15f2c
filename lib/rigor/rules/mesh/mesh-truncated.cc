// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>
#include <string>

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_truncated {
namespace {

void check(const MeshFile& file, Context& context) {
  const mesh::Fault* fault = fault_of(file, mesh::FaultKind::kTruncated);
  if (fault == nullptr) return;
  const std::uint64_t promised = file.facts.triangles + fault->count;
  report_mesh(file, context,
              file.facts.format == mesh::Format::kStlAscii
                  ? "the mesh ends within a facet" + in_line(fault->line)
                  : "the mesh promises " + how_many(promised, "triangle") + " and holds " +
                        std::to_string(file.facts.triangles) + in_line(fault->line));
}

}  // namespace

Rule rule() {
  return {
      .name = "mesh-truncated",
      .category = Category::kMesh,
      .severity = Severity::kError,
      .summary = "a mesh file is cut short",
      .why =
          "A copy, download or export was broken off. Assimp and MuJoCo refuse the file; "
          "admesh fills up what is missing with triangles of its own.",
      .what_to_do = "Get or export the whole file again.",
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
vertex 0 1)"}},
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

}  // namespace rigor::rules::mesh_truncated
