// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/scene_input.h>

namespace rigor::simulate {

SceneFiles::SceneFiles(const read::Loaded& loaded, read::Workspace& workspace,
                       const read::Resolver& resolver, const model::JointPositions& positions)
    : workspace_(workspace),
      resolver_(resolver),
      frames_(loaded.root, positions),
      documents_(workspace),
      surveys_(workspace.disk()),
      input_{loaded.root,
             frames_,
             documents_,
             [this](const model::Mesh& mesh) -> const mass::MeshSurvey* {
               const std::string path = path_of(mesh);
               if (path.empty()) return nullptr;
               return &surveys_.find({path, mesh.submesh.value, mesh.center.value});
             },
             [this](const model::Mesh& mesh) -> const mesh::LoadedMesh* {
               const std::string path = path_of(mesh);
               if (path.empty()) return nullptr;
               auto& known = meshes_[path];
               if (!known) {
                 known =
                     std::make_unique<mesh::LoadedMesh>(mesh::read_mesh(workspace_.disk(), path));
               }
               return known.get();
             },
             positions} {}

std::string SceneFiles::path_of(const model::Mesh& mesh) const {
  if (mesh.uri.value.empty() || mesh.uri.span.nowhere()) return {};
  const std::string from(workspace_.sources().path(mesh.uri.span.source));
  return workspace_.resolve(resolver_, mesh.uri.value, from).path.value_or("");
}

}  // namespace rigor::simulate
