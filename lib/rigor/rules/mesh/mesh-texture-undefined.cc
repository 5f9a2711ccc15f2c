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
    report_mesh(file, context, "an image names no file" + in_line(nameless->line));
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
      .why =
          "Assimp refuses the whole file, and so whoever reads Collada by it, as RViz does: "
          "\"Invalid texture, no data or file reference given\". Gazebo's own reader opens it "
          "without the picture. Found in 3 of 100 Collada files of Gazebo's models, from 3ds Max.",
      .what_to_do = "Write the mesh anew, without the texture: `rigor mesh-check FILE -o OUT.dae`. "
                    "Or export it with its textures.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_texture_undefined
