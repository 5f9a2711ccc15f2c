// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/simplify/mesh_files.h>

#include <utility>

#include <fmt/core.h>

#include <rigor/author/mesh_uri.h>
#include <rigor/mesh/write/write.h>
#include <rigor/text/path.h>
#include <rigor/write/safe_name.h>

namespace rigor::author {

std::optional<std::string> MeshFiles::add(const OldMesh& old, std::string_view suffix,
                                          mesh::TriangleMesh mesh) {
  const std::string_view name = file_name(old.path);
  std::string bytes = mesh::write_stl(mesh);
  std::string path =
      free_path(std::string(parent_path(old.path)),
                fmt::format("{}_{}", name.substr(0, name.rfind('.')), suffix), bytes);
  auto uri = renamed_uri(edited_.environment.resolver, old.uri, edited_.path(), old.path, path);
  if (!uri) return std::nullopt;
  meshes_[*uri] = std::make_shared<mesh::TriangleMesh>(std::move(mesh));
  files_[*uri] = {std::move(path), std::move(bytes)};
  return uri;
}

std::shared_ptr<const mesh::TriangleMesh> MeshFiles::surface(const std::string& uri) const {
  const auto found = meshes_.find(uri);
  return found == meshes_.end() ? nullptr : found->second;
}

/// A name of no file, or of one with these bytes.
std::string MeshFiles::free_path(const std::string& folder, const std::string& name,
                                 const std::string& bytes) {
  for (int i = 1;; ++i) {
    const std::string numbered = i == 1 ? name : fmt::format("{}_{}", name, i);
    std::string path = join_path(folder, write::safe_name(numbered) + ".stl");
    const auto [taken, is_new] = taken_.try_emplace(path, bytes);
    if (!is_new) {
      if (taken->second == bytes) return path;
      continue;
    }
    const Disk& disk = edited_.environment.disk;
    if (disk.kind(path) == PathKind::kMissing ||
        disk.read(path, bytes.size() + 1).bytes == bytes)  // an earlier run
      return path;
    taken->second.clear();
  }
}

}  // namespace rigor::author
