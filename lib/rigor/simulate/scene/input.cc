// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/scene/input.h>

#include <utility>

namespace rigor::simulate {

SceneFiles::SceneFiles(const read::Loaded& loaded, read::Workspace& workspace,
                       const read::Resolver& resolver, const process::Workers& workers,
                       const model::JointPositions& positions)
    : workspace_(workspace),
      resolver_(resolver),
      workers_(workers),
      start_(start_within_limits(loaded.root, positions)),
      frames_(loaded.root, start_.positions),
      documents_(workspace),
      surveys_(workspace.disk(), {.workers = &workers}),
      input_{loaded.root,
             frames_,
             documents_,
             [this](const model::Mesh& mesh) -> const mass::MeshSurvey* {
               const std::string path = path_of(mesh.uri);
               if (path.empty()) return nullptr;
               return &surveys_.find(mass::mesh_choice(path, mesh));
             },
             [this](const model::Mesh& mesh) -> const mesh::LoadedMesh* {
               const std::string path = path_of(mesh.uri);
               if (path.empty()) return nullptr;
               auto& known = meshes_[path];
               if (!known) {
                 known = std::make_unique<mesh::LoadedMesh>(
                     mesh::read_mesh(workspace_.disk(), path, workers_));
               }
               return known.get();
             },
             [this](const model::Heightmap& heightmap) -> const LoadedHeights& {
               const std::string path = path_of(heightmap.uri);
               const auto known = heights_.find(path);
               if (!path.empty() && known != heights_.end()) return known->second;
               return heights_[path] = heights_at(path, heightmap.uri.value);
             },
             start_.positions,
             start_.moved} {}

std::string SceneFiles::path_of(const model::Field<std::string>& uri) const {
  if (uri.value.empty() || uri.span.nowhere()) return {};
  const std::string from(workspace_.sources().path(uri.span.source));
  return workspace_.resolve(resolver_, uri.value, from).path.value_or("");
}

LoadedHeights SceneFiles::heights_at(const std::string& path, const std::string& uri) const {
  if (path.empty()) return {{}, uri + " is not found"};
  const ReadResult file = workspace_.disk().read(path, read::kMaxModelBytes);
  if (!file.bytes) return {{}, uri + " cannot be read: " + file.problem};
  auto picture = mesh::read_height_picture(*file.bytes);
  if (picture) return {std::move(picture), {}};
  const std::string most = std::to_string(mesh::kMaxHeightPicture);
  return {{}, uri + " is no PNG, is damaged, or is over " + most + " pixels wide"};
}

}  // namespace rigor::simulate
