// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_facet_colors {

void check(const MeshFile& file, Context& context) {
  const auto& stl = file.facts.asset.stl;
  if (!stl || file.collision()) return;
  if (stl->color_header) {
    report_mesh(file, context, "the STL has colours, which other programs do not see (COLOR=)");
  } else if (stl->attributes.count > 0) {
    report_mesh(file, context,
                how_many(stl->attributes.count, "facet") + " of the STL" +
                    (stl->attributes.count == 1 ? " has" : " have") +
                    " attributes, perhaps colours, which other programs do not see");
  }
}

Rule rule() {
  return {
      .name = "mesh-facet-colors",
      .severity = Severity::kInfo,
      .summary = "an STL has colours that get lost",
      .why =
          "Some programs put colours into two spare bytes of each facet or into the header. RViz "
          "and, but for the first kind, assimp pass over them: the part is drawn in one colour.",
      .what_to_do = "Export the part in a format with colours: DAE, GLB or OBJ.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_facet_colors
