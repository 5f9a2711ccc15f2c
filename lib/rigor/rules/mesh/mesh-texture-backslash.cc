// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/texture.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_texture_backslash {

void check(const MeshFile& file, Context& context) {
  if (!is_drawn(file)) return;
  report_references(file, context,
                    in_state(file.facts.asset.textures, mesh::FileReference::State::kBackslash),
                    "a texture's path is written with a backslash",
                    "textures' paths are written with backslashes");
}

Rule rule() {
  return {
      .name = "mesh-texture-backslash",
      .severity = Severity::kWarning,
      .summary = "a texture's path is written with backslashes",
      .why = "Only Windows takes \\ for what parts folders. On Linux it is a letter of the name, "
             "and no file is found.",
      .what_to_do = "Write / in place of \\ in the mesh file, which Windows understands, too.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_texture_backslash
