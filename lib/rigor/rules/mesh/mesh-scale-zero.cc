// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_scale_zero {
namespace {

void check(const MeshUse& use, Context& context) {
  const auto& scale = use.mesh.scale;
  const auto [x, y, z] = scale.value;
  if (!scale.written || (x != 0 && y != 0 && z != 0)) return;
  context.report({.where = scale.span,
                  .message = "a scale of zero makes the mesh flat: it has no volume",
                  .subject = use.subject});
}

}  // namespace

Rule rule() {
  return {
      .name = "mesh-scale-zero",
      .category = Category::kMesh,
      .severity = Severity::kError,
      .summary = "a mesh is scaled by zero",
      .why =
          "The mesh becomes a plane, a line or a point. It cannot be seen or touched, and "
          "engines that build a hull of it stop.",
      .what_to_do = "Write the factor from the file's unit to metres: 0.001 for millimetres.",
      .bad = {{R"(<sdf version="1.9">
  <model name="arm">
    <static>true</static>
    <link name="body">
      <visual name="hull">
        <geometry>
          <mesh>
            <uri>meshes/hull.obj</uri>
            <scale>«1 1 0»</scale>
          </mesh>
        </geometry>
      </visual>
    </link>
  </model>
</sdf>
=== meshes/hull.obj
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
  <model name="arm">
    <static>true</static>
    <link name="body">
      <visual name="hull">
        <geometry>
          <mesh>
            <uri>meshes/hull.obj</uri>
            <scale>0.001 0.001 0.001</scale>
          </mesh>
        </geometry>
      </visual>
    </link>
  </model>
</sdf>
=== meshes/hull.obj
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
)"}},
      .checks = {on<MeshUse>(check)},
  };
}

}  // namespace rigor::rules::mesh_scale_zero
