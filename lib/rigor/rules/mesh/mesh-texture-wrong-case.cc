// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/texture.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_texture_wrong_case {

void check(const MeshFile& file, Context& context) {
  if (!is_drawn(file)) return;
  report_references(file, context,
                    in_state(file.facts.asset.textures, mesh::FileReference::State::kWrongCase),
                    "a texture is written with other upper and lower case",
                    "textures are written with other upper and lower case");
}

Rule rule() {
  return {
      .name = "mesh-texture-wrong-case",
      .severity = Severity::kWarning,
      .summary = "a texture is written with other upper and lower case",
      .why = "It opens on Windows and macOS, and is not found on Linux, where the simulators "
             "mostly run.",
      .what_to_do = "Rename the picture, or write its name in the mesh as the file has it.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_texture_wrong_case
