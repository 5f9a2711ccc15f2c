// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>

#include <rigor/rules/mesh/texture.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_texture_missing {

/// Gazebo draws a visual that has a <material> of its own with that, whatever the mesh says. RViz
/// takes a URDF's material only for meshes without any.
bool painted_over(const MeshFile& file, const Context& context) {
  return context.is_sdf() && file.use != nullptr && file.use->painted;
}

void check(const MeshFile& file, Context& context) {
  if (!is_drawn(file) || painted_over(file, context)) return;
  report_references(file, context,
                    in_state(file.facts.asset.textures, mesh::FileReference::State::kMissing),
                    "a texture is not found", "textures are not found");
}

Rule rule() {
  return {
      .name = "mesh-texture-missing",
      .severity = Severity::kWarning,
      .summary = "a texture of a mesh is not found",
      .why = "The part is drawn in one colour, often white or black. Names are looked for beside "
             "the file that names them; Gazebo looks in ../materials/textures, too.",
      .what_to_do =
          "Put the picture where the mesh says it is, or export the mesh with the right path.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_texture_missing
