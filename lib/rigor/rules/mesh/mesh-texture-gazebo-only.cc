// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/texture.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_texture_gazebo_only {

void check(const MeshFile& file, Context& context) {
  using State = mesh::FileReference::State;
  if (!is_drawn(file)) return;
  const References& all = file.facts.asset.textures;
  References found = in_state(all, State::kTextures);
  const References urls = in_state(all, State::kUrl);
  found.insert(found.end(), urls.begin(), urls.end());
  report_references(file, context, found, "a texture is where only Gazebo looks",
                    "textures are where only Gazebo looks");
}

Rule rule() {
  return {
      .name = "mesh-texture-gazebo-only",
      .severity = Severity::kInfo,
      .summary = "a texture of a mesh is where only Gazebo looks",
      .why = "Gazebo looks for textures in ../materials/textures, too, and follows model: URIs "
             "inside of mesh files. RViz and others look beside the mesh only, and draw the part "
             "in one colour.",
      .what_to_do = "Write the path from the mesh to the picture into the mesh file, such as "
                    "../materials/textures/skin.png, which everyone finds.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_texture_gazebo_only
