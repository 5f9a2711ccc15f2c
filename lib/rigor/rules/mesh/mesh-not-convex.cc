// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_not_convex {

void check(const MeshFile& file, Context& context) {
  if (file.use || !file.facts.shape) return;
  const mass::MeshShape& shape = *file.facts.shape;
  if (shape.convex || !shape.topology.closed() || shape.moments.volume <= 0) return;
  report_mesh(file, context, "the mesh is not convex: engines that take its hull fill its hollows");
}

Rule rule() {
  return {
      .name = "mesh-not-convex",
      .severity = Severity::kInfo,
      .summary = "a mesh is not convex",
      .why = "Most meshes are not. MuJoCo collides with the hull of a mesh, so that hollows are "
             "filled: a cup holds nothing. So do engines elsewhere when they are told to be fast.",
      .what_to_do =
          "Where hollows matter, split the mesh into convex pieces, each a collision of its own; "
          "where they do not, `rigor mesh-check FILE --convex-hull -o OUT` shows what is touched.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_not_convex
