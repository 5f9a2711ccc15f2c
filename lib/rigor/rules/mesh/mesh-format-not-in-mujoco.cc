// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>

#include <rigor/rules/mesh/mujoco_compiler.h>
#include <rigor/rules/rule.h>
#include <rigor/text/path.h>

namespace rigor::rules::mesh_format_not_in_mujoco {

/// What no simulator reads is reported whatever the file is for.
bool is_of_others(std::string_view ending) {
  return ending == ".dae" || ending == ".glb" || ending == ".gltf" || ending == ".ply" ||
         ending == ".fbx";
}

void check(const model::Root& /*root*/, Context& context) {
  const MujocoCompiler settings = mujoco_compiler(context.root());
  for (const MujocoMesh& one : mujoco_meshes(settings, context)) {
    const std::string& uri = one.mesh->uri.value;
    if (!is_of_others(extension(uri))) continue;
    context.report({.where = one.mesh->uri.span,
                    .message = "MuJoCo does not read '" + extension(uri) +
                               "' meshes: it knows .stl, .obj and .msh",
                    .subject = one.subject});
  }
}

Rule rule() {
  return {
      .name = "mesh-format-not-in-mujoco",
      .severity = Severity::kError,
      .formats = Formats::kUrdf,
      .targets = {Target::kMujoco},
      .summary = "a mesh has a format that MuJoCo does not read",
      .why = "MuJoCo rejects the whole robot: unknown mesh file type. It reads STL, OBJ and its "
             "own MSH, and decides by the ending of the name. Of a URDF it reads the meshes of "
             "collisions; those of visuals only when <mujoco><compiler discardvisual=\"false\"/> "
             "asks for them.",
      .what_to_do = "Convert the mesh: `rigor mesh-check FILE -o FILE.obj`.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::mesh_format_not_in_mujoco
