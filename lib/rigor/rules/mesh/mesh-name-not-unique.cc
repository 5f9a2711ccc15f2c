// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <map>
#include <string>
#include <string_view>

#include <rigor/read/resolver.h>
#include <rigor/rules/mesh/mujoco_compiler.h>
#include <rigor/rules/rule.h>
#include <rigor/text/path.h>

namespace rigor::rules::mesh_name_not_unique {

struct Known {
  const model::Mesh* mesh;
  std::string path;
};

std::string stem(std::string_view uri) {
  const std::string_view name = file_name(uri);
  return std::string(name.substr(0, name.rfind('.')));
}

bool same_scale(const model::Mesh& a, const model::Mesh& b) {
  return a.scale.value == b.scale.value;
}

void check(const model::Root& /*root*/, Context& context) {
  const MujocoCompiler settings = mujoco_compiler(context.root());
  std::map<std::string, Known> by_name;
  for (const MujocoMesh& one : mujoco_meshes(settings, context)) {
    const std::string& uri = one.mesh->uri.value;
    const auto& path = context.resolve(uri).path;
    if (!path || !mujoco_reads(uri)) continue;
    const auto [known, is_new] = by_name.try_emplace(stem(uri), Known{one.mesh, *path});
    if (is_new || known->second.path == *path) continue;
    const model::Mesh& other = *known->second.mesh;
    // Of another scale it makes a mesh of its own, of the file that it finds by the bare name.
    const bool same_file = settings.strip_path && file_name(uri) == file_name(other.uri.value);
    if (!same_scale(*one.mesh, other) && !same_file) continue;
    context.report({.where = one.mesh->uri.span,
                    .message = "MuJoCo takes '" + other.uri.value +
                               "' for this mesh: both are called '" + stem(uri) + "'",
                    .subject = one.subject,
                    .related = {{other.uri.span, "the mesh that it takes"}}});
  }
}

Rule rule() {
  return {
      .name = "mesh-name-not-unique",
      .severity = Severity::kError,
      .formats = Formats::kUrdf,
      .targets = {Target::kMujoco},
      .summary = "two meshes of a robot differ by folder or ending only",
      .why = "MuJoCo calls the meshes of a URDF by their file names without folder and ending, and "
             "reads one file for each name: the second shape gets the mesh of the first, and "
             "nothing is said.",
      .what_to_do = "Give the files different names, such as car_collision.stl.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::mesh_name_not_unique
