// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/texture.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_texture_absolute {

void check(const MeshFile& file, Context& context) {
  if (!is_drawn(file)) return;
  report_references(file, context,
                    in_state(file.facts.asset.textures, mesh::FileReference::State::kAbsolute),
                    "a texture has an absolute path", "textures have absolute paths");
}

Rule rule() {
  return {
      .name = "mesh-texture-absolute",
      .severity = Severity::kWarning,
      .summary = "a texture has an absolute path",
      .why = "The path is that of the machine where the mesh was made. On any other the picture is "
             "not found.",
      .what_to_do = "Put the picture beside the mesh, and export it with relative paths.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_texture_absolute
