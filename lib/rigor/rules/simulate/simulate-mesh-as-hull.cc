// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/sample.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_mesh_as_hull {

void check(const simulate::Fact& fact, Context& context) {
  const char* why = fact.name == "convex"      ? "which it nearly is"
                    : fact.name == "too large" ? "since it has too many triangles"
                                               : "as was asked for";
  context.report(shown(fact, fmt::format("the mesh is simulated as its convex hull, {}", why)));
}

Rule rule() {
  return {
      .name = "simulate-mesh-as-hull",
      .category = Category::kSimulate,
      .severity = Severity::kInfo,
      .summary = "a collision mesh is simulated as its convex hull",
      .why =
          "Engines collide convex shapes well and triangles badly, and an open mesh has no "
          "inside. What the hull adds collides too.",
      .what_to_do =
          "Nothing, where the hull is good enough; else `rigor mesh-check FILE --convex-"
          "pieces 16` makes convex pieces of it.",
      .bad = {{.text = R"(<sdf version='1.9'>
  <model name='wedge'>
    <link name='body'>
      <pose>0 0 0.1 0 0 0</pose>
      <inertial>
        <mass>6</mass>
        <inertia><ixx>0.04</ixx><iyy>0.04</iyy><izz>0.04</izz></inertia>
      </inertial>
      <collision name='c'>
        <geometry><«mesh»><uri>wedge.obj</uri></mesh></geometry>
      </collision>
    </link>
  </model>
</sdf>
=== wedge.obj
v -0.1 -0.1 -0.1
v 0.2 -0.1 -0.1
v -0.1 0.2 -0.1
v -0.1 -0.1 0.2
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
)"}},
      .good = {{.text = kStandingBox}},
      .checks = {on_simulation({simulate::FactKind::kMeshAsHull}, check)},
  };
}

}  // namespace rigor::rules::simulate_mesh_as_hull
