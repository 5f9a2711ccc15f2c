// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/mesh/mesh_list.h>

#include <map>
#include <memory>
#include <variant>

#include <rigor/text/digest.h>

namespace rigor::mass {
namespace {

/// As deep as rules look at a mesh, so that nothing is examined twice.
using DepthByPath = std::map<std::string, MeshDepth>;

template <class Entity>
void add_paths(const model::Root& root, const std::vector<Entity>& entities, MeshDepth depth,
               const MeshList::FindPath& find, DepthByPath& paths) {
  for (const Entity& entity : entities) {
    const auto* const mesh = std::get_if<model::Mesh>(&entity.geometry.shape);
    if (mesh == nullptr || mesh->uri.value.empty() || !root.own(entity.site)) continue;
    if (const std::optional<std::string> path = find(mesh->uri.value)) paths.emplace(*path, depth);
  }
}

std::optional<OpenedMesh> opened(const Disk& disk, MeshFiles& files, const std::string& path,
                                 MeshDepth depth) {
  const std::unique_ptr<OpenFile> file = disk.open(path);
  if (!file) return std::nullopt;
  OpenedMesh mesh{path, hex(digest_of(*file)), file->size()};
  const MeshFacts& facts = files.find(path, depth);
  if (!facts.usable()) return mesh;
  mesh.triangles = facts.triangles;
  if (facts.triangles == 0) return mesh;
  mesh.min = facts.bounds.min;
  mesh.max = facts.bounds.max;
  return mesh;
}

}  // namespace

std::vector<OpenedMesh> MeshList::of(const model::Root& root, const FindPath& find) {
  DepthByPath paths;
  add_paths(root, root.collisions, MeshDepth::kShape, find, paths);
  add_paths(root, root.visuals, MeshDepth::kFile, find, paths);
  std::vector<OpenedMesh> meshes;
  for (const auto& [path, depth] : paths) {
    const auto& mesh = known_.find(
        path, [&, &path = path, depth = depth] { return opened(disk_, files_, path, depth); });
    if (mesh) meshes.push_back(*mesh);
  }
  return meshes;
}

}  // namespace rigor::mass
