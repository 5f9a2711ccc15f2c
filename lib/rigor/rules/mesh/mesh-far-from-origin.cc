// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_far_from_origin {

// Times the mesh's diagonal. Of 1,400 real meshes none is farther away; a quarter is more than half.
constexpr double kFar = 10;

void check(const MeshFile& file, Context& context) {
  if (takes_part(file) || !file.facts.usable()) return;
  const double size = mesh::diagonal(file.facts.bounds);
  const model::Vector3 center = middle(file.facts.bounds);
  const double distance = length(center);
  if (!(distance > kFar * size) || size == 0) return;
  report_mesh(file, context,
              fmt::format("the mesh is {} across and its center {} from its origin, at {}",
                          length_in(file, size), length_in(file, distance), place(center)));
}

Rule rule() {
  return {
      .name = "mesh-far-from-origin",
      .severity = Severity::kInfo,
      .summary = "a mesh is far from its own origin",
      .why = "It was exported at its place in an assembly or on a map. A pose rotates it about a "
             "point that is far away, and the 32-bit numbers of files and graphics cards lose "
             "digits with the distance.",
      .what_to_do = "Move it to its origin and add the offset to the pose: `rigor mesh-check "
                    "FILE --center bounds -o OUT`.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_far_from_origin
