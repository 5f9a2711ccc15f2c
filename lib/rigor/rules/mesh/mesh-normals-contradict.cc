// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <fmt/core.h>

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_normals_contradict {
namespace {

void check(const MeshFile& file, Context& context) {
  const auto& stl = file.facts.asset.stl;
  if (!stl || stl->contrary_normals.count == 0 || file.collision()) return;
  const mesh::Sighting& contrary = stl->contrary_normals;
  report_mesh(file, context,
              fmt::format("{} of {} facets have a normal that points to the other side than the "
                          "order of the corners says, first {}",
                          contrary.count, stl->facets,
                          (stl->binary ? "facet " : "in line ") + std::to_string(contrary.first)));
}

}  // namespace

Rule rule() {
  return {
      .name = "mesh-normals-contradict",
      .category = Category::kMesh,
      .severity = Severity::kWarning,
      .summary = "normals of an STL contradict the order of its corners",
      .why =
          "Some viewers light a facet by its normal, and leave it out by the order of its "
          "corners: it is dark, or cannot be seen. Which of the two is right the file does not "
          "say; engines and mass properties go by the corners.",
      .what_to_do =
          "Turn the facets outward and write their normals anew: `rigor mesh-check FILE "
          "--repair -o OUT.stl`.",
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
facet normal 0 0 1
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

}  // namespace rigor::rules::mesh_normals_contradict
