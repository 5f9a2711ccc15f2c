// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/rule.h>
#include <rigor/text/path.h>

namespace rigor::rules::mesh_format_not_in_isaac {

void check(const MeshUse& use, Context& context) {
  const std::string ending = extension(use.mesh.uri.value);
  // What no simulator reads is reported whatever the file is for.
  if (ending != ".glb" && ending != ".gltf" && ending != ".ply" && ending != ".fbx") return;
  context.report(
      {.where = use.mesh.uri.span,
       .message = "Isaac Sim's importer of URDF reads .stl, .obj and .dae, and no " + ending,
       .subject = use.subject});
}

Rule rule() {
  return {
      .name = "mesh-format-not-in-isaac",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .targets = {Target::kIsaac},
      .summary = "a mesh has a format that Isaac Sim's importer of URDF does not read",
      .why = "The importer is built on urdf-usd-converter, which reads OBJ, DAE and STL: any other "
             "mesh is left out.",
      .what_to_do = "Convert the mesh: `rigor mesh-check FILE -o FILE.obj`.",
      .checks = {on<MeshUse>(check)},
  };
}

}  // namespace rigor::rules::mesh_format_not_in_isaac
