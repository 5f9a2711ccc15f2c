// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <string>
#include <utility>

#include <rigor/read/resolver.h>
#include <rigor/rules/mesh/mujoco_compiler.h>
#include <rigor/rules/rule.h>
#include <rigor/text/path.h>

namespace rigor::rules::mesh_not_beside_urdf {

void check(const model::Root& /*root*/, Context& context) {
  const MujocoCompiler settings = mujoco_compiler(context.root());
  const std::string folder = join_path(context.folder(), settings.mesh_folder);
  const MujocoMesh* first = nullptr;
  std::string place;
  std::size_t count = 0;
  const auto meshes = mujoco_meshes(settings, context);
  for (const MujocoMesh& one : meshes) {
    const std::string& uri = one.mesh->uri.value;
    // What no consumer reads, or finds, is reported by other rules.
    if (!mujoco_reads(uri) || !context.resolve(uri).path) continue;
    std::string sought = settings.strip_path ? join_path(folder, file_name(uri)) : uri;
    if (!settings.strip_path && uri.find("://") == std::string::npos)
      sought = join_path(folder, uri);
    if (context.disk().kind(sought) == PathKind::kFile) continue;
    if (count++ > 0) continue;
    first = &one;
    place = std::move(sought);
  }
  if (first == nullptr) return;
  const std::string more = count > 1 ? ", nor " + std::to_string(count - 1) + " more" : "";
  context.report(
      {.where = first->mesh->uri.span,
       .message = "MuJoCo looks for this mesh at '" + place + "' and does not find it" + more,
       .subject = first->subject});
}

Rule rule() {
  return {
      .name = "mesh-not-beside-urdf",
      .severity = Severity::kError,
      .formats = Formats::kUrdf,
      .targets = {Target::kMujoco},
      .summary = "a mesh is not where MuJoCo looks for it",
      .why = "Of the meshes in a URDF, MuJoCo takes the bare file name, without folders and "
             "package://, and opens it beside the URDF, or in the folder that <compiler "
             "meshdir=\"…\"/> names. When it is not there, it rejects the whole robot.",
      .what_to_do = "Add <mujoco><compiler meshdir=\"../meshes\"/></mujoco> to the <robot>, or "
                    "with relative file names <compiler strippath=\"false\"/>. Others ignore the "
                    "<mujoco> element. It is reported once in a file.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::mesh_not_beside_urdf
