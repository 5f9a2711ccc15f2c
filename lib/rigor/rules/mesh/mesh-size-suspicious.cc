// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>

#include <fmt/core.h>

#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_size_suspicious {
namespace {

// Diagonals, in metres. In 2,000 real model files no mesh that may move is beyond them; what stands fast
// may be a building or terrain.
constexpr double kLarge = 50;
constexpr double kSmall = 0.005;
// What a link may be expected to measure.
constexpr double kLikelySmall = 0.01;
constexpr double kLikelyLarge = 5;

struct Unit {
  std::string_view name;
  double meter;
};
constexpr Unit kUnits[] = {{"millimetres", 0.001}, {"inches", 0.0254}, {"centimetres", 0.01}};

bool stands_fast(const MeshFile& file, const Context& context) {
  const model::Link* link = link_of(file, context);
  return link && link->model && context.root().models[link->model.value].is_static.value;
}

/// "; in millimetres it would have 0.35 m": the first unit in which it has the size of a link.
std::string too_large(double size) {
  for (const Unit& unit : kUnits) {
    const double meant = size * unit.meter;
    if (meant < kLikelySmall || meant > kLikelyLarge) continue;
    return fmt::format("; if it is drawn in {}, {:.3g} m are meant", unit.name, meant);
  }
  return {};
}

/// The same of one that was shrunk once too often.
std::string too_small(double size) {
  for (const Unit& unit : kUnits) {
    const double meant = size / unit.meter;
    if (meant < kLikelySmall || meant > kLikelyLarge) continue;
    return fmt::format("; if the scale from {} was applied twice, {:.3g} m are meant", unit.name,
                       meant);
  }
  return {};
}

void check(const MeshFile& file, Context& context) {
  if (!file.use || takes_part(file) || !file.facts.usable()) return;
  const double size = mesh::diagonal(scaled_bounds(file));
  const bool large = size > kLarge;
  if (!(large || (size > 0 && size < kSmall)) || stands_fast(file, context)) return;
  report_mesh(file, context,
              fmt::format("the mesh is {:.3g} m across, which is {} for a link{}", size,
                          large ? "much" : "little", large ? too_large(size) : too_small(size)));
}

}  // namespace

Rule rule() {
  return {
      .name = "mesh-size-suspicious",
      .category = Category::kMesh,
      .severity = Severity::kWarning,
      .summary = "a mesh is as large as a building or as small as a grain",
      .why =
          "STL and OBJ do not say what a unit is. A part drawn in millimetres and read in "
          "metres is a thousand times too large, one scaled twice as much too small; drawn with "
          "a thousandth of its size a robot is just not to be seen. Contacts, inertia and "
          "camera ranges go wrong with it.",
      .what_to_do =
          "Give the mesh's unit in the model's scale (0.001 for millimetres), or put it into "
          "the file: `rigor mesh-check FILE --unit mm -o OUT`.",
      .bad = {{R"(<sdf version="1.9">
  <model name="part">
    <link name="body">
      <inertial>
        <mass>1</mass>
        <inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia>
      </inertial>
      <collision name="shell">
        <geometry><mesh><uri>«meshes/shell.obj»</uri></mesh></geometry>
      </collision>
    </link>
  </model>
</sdf>
=== meshes/shell.obj
v 0 0 0
v 200 0 0
v 0 200 0
v 0 0 200
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="part">
    <link name="body">
      <inertial>
        <mass>1</mass>
        <inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia>
      </inertial>
      <collision name="shell">
        <geometry>
          <mesh>
            <uri>meshes/shell.obj</uri>
            <scale>0.001 0.001 0.001</scale>
          </mesh>
        </geometry>
      </collision>
    </link>
  </model>
</sdf>
=== meshes/shell.obj
v 0 0 0
v 200 0 0
v 0 200 0
v 0 0 200
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
)"},
               {R"(<sdf version="1.9">
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
v 200 0 0
v 0 200 0
v 0 0 200
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
)"}},
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_size_suspicious
