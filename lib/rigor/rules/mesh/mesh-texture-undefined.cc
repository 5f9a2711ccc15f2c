// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include <rigor/rules/mesh/texture.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_texture_undefined {

// Not of visuals only: of a collision the shape is lost, too.
void check(const MeshFile& file, Context& context) {
  References undefined =
      in_state(file.facts.asset.textures, mesh::FileReference::State::kUndefined);
  const auto nameless = std::find_if(undefined.begin(), undefined.end(),
                                     [](const auto& image) { return image.written.empty(); });
  if (nameless != undefined.end()) {
    report_mesh(
        file, context, "an <image> has no file name" + in_line(nameless->line),
        "Assimp, with which RViz reads Collada, rejects the whole mesh; Gazebo's own reader "
        "loads it without the texture.");
    undefined.erase(nameless);
  }
  report_references(file, context, undefined, "a texture is not defined in the mesh file",
                    "textures are not defined in the mesh file");
}

Rule rule() {
  return {
      .name = "mesh-texture-undefined",
      .severity = Severity::kWarning,
      .summary = "a material names a texture that the file does not define",
      .why = "Assimp, with which RViz reads Collada, and Gazebo's own reader load the mesh without "
             "the texture. An <image> that names no file is worse: assimp rejects the mesh "
             "(\"Invalid texture, no data or file reference given\"), and 5.2.5 stops at an "
             "assertion when its <init_from> is empty. The exporter of 3ds Max writes both.",
      .what_to_do = "Export the mesh with its textures, or without the material's texture: `rigor "
                    "mesh-check FILE -o OUT.dae` writes it so.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_texture_undefined
