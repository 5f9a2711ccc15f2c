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
              fmt::format("the mesh is {} across and its middle {} from its origin, at {}",
                          length_in(file, size), length_in(file, distance), place(center)));
}

Rule rule() {
  return {
      .name = "mesh-far-from-origin",
      .severity = Severity::kWarning,
      .summary = "a mesh is far from its own origin",
      .why = "It was exported where it stood in an assembly or on a map. A pose turns it round a "
             "point that is nowhere near it, and numbers of 32 bits, as files and graphics cards "
             "have them, lose digits with the distance.",
      .what_to_do = "Move it to its origin and put the distance into the pose: `rigor mesh-check "
                    "FILE --center bounds -o OUT`.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_far_from_origin
