// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/mesh/triangle_budget.h>
#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_visual_triangles {

void check(const MeshFile& file, Context& context) {
  if (!file.visual() || takes_part(file) || file.facts.triangles <= mesh::kMaxVisualTriangles)
    return;
  report_mesh(file, context,
              fmt::format("the mesh has {} triangles, over {}", file.facts.triangles,
                          mesh::kMaxVisualTriangles));
}

Rule rule() {
  return {
      .name = "mesh-visual-triangles",
      .severity = Severity::kWarning,
      .summary = "a mesh to be seen has more than 100 000 triangles",
      .why = "Viewers and simulated cameras draw each of them in every frame, and each start reads "
             "them. The largest of a thousand meshes of real robots has 75 000; nine of ten have "
             "fewer than 22 000.",
      .what_to_do = "Reduce it: `rigor mesh-check FILE --reduce 50000 -o OUT`.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_visual_triangles
