// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>

#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_nonmanifold_edge {
namespace {

void check(const MeshFile& file, Context& context) {
  const mass::MeshShape* shape = shape_of(file);
  if (!shape) return;
  const mesh::Topology& topology = shape->topology;
  const std::uint64_t count = topology.nonmanifold_edges;
  if (count == 0) return;
  report_mesh(file, context,
              how_many(count, "edge has", "edges have") + " more than two triangles" +
                  at_defects(topology, mesh::Defect::kNonmanifoldEdge, count));
}

}  // namespace

Rule rule() {
  return {
      .name = "mesh-nonmanifold-edge",
      .category = Category::kMesh,
      .severity = Severity::kInfo,
      .summary = "edges of a mesh have more than two triangles",
      .why =
          "Walls without thickness and bodies that touch along an edge look like this. Which "
          "side of such an edge is inside is not defined there, so that booleans, hole filling "
          "and many mesh tools refuse the mesh or cut it there.",
      .what_to_do =
          "Keep touching bodies apart, and give walls a thickness. `rigor mesh-check FILE "
          "--repair -o OUT` takes away triangles that are there twice, a common cause.",
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
# a fin on an edge of a tetrahedron
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
v 1 -1 0
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
f 1 2 5
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
)"}},
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_nonmanifold_edge
