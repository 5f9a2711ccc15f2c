// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/rules/rule.h>
#include <rigor/text/disk.h>
#include <rigor/text/letter_case.h>
#include <rigor/text/path.h>

namespace rigor::rules::mesh_unreferenced {

// A model's folder has a dozen files and folders; a folder with more is not checked.
constexpr std::size_t kMaxEntries = 1000;
constexpr int kDeepest = 4;
constexpr std::uint64_t kLargestText = std::uint64_t{8} << 20U;
// Bytes compared with names: some hundredths of a second.
constexpr std::uint64_t kMaxCompared = std::uint64_t{100} << 20U;

constexpr std::string_view kMeshes[] = {".stl", ".dae", ".obj", ".glb", ".gltf", ".ply", ".fbx"};
/// Beside meshes, what is no text.
constexpr std::string_view kSilent[] = {".png",  ".jpg", ".tga", ".jpeg", ".bmp", ".dds", ".tif",
                                        ".tiff", ".gif", ".bin", ".mtl",  ".zip", ".so"};

template <std::size_t N>
bool is_one_of(const std::string& ending, const std::string_view (&list)[N]) {
  return std::find(std::begin(list), std::end(list), ending) != std::end(list);
}

/// Paths below the folder, without those of models in it; none when there are too many.
std::vector<std::string> files_below(const std::string& top, const Disk& disk) {
  std::vector<std::string> files;
  std::vector<std::pair<std::string, int>> open{{top, 0}};
  std::size_t entries = 0;
  while (!open.empty()) {
    const auto [folder, depth] = open.back();
    open.pop_back();
    const std::vector<std::string> names = disk.list(folder);
    entries += names.size();
    if (entries > kMaxEntries) return {};
    for (const std::string& name : names) {
      const std::string path = join_path(folder, name);
      const PathKind kind = disk.kind(path);
      if (kind == PathKind::kFile) files.push_back(path);
      const bool below = kind == PathKind::kFolder && depth < kDeepest && name != "thumbnails";
      if (!below || name.starts_with('.')) continue;
      if (disk.kind(join_path(path, "model.config")) != PathKind::kFile) {
        open.emplace_back(path, depth + 1);
      }
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> meshes_among(const std::vector<std::string>& files) {
  std::vector<std::string> meshes;
  for (const std::string& path : files) {
    if (is_one_of(extension(path), kMeshes)) meshes.push_back(path);
  }
  return meshes;
}

/// Takes away the meshes that are named in a text of the folder. False when that is too much to read.
bool leave_unnamed(const std::vector<std::string>& files, const Disk& disk,
                   std::vector<std::string>& meshes) {
  std::uint64_t compared = 0;
  for (const std::string& path : files) {
    if (meshes.empty()) return true;
    if (is_one_of(extension(path), kSilent) || is_one_of(extension(path), kMeshes)) continue;
    auto bytes = disk.read(path, kLargestText).bytes;
    if (!bytes) return false;
    compared += bytes->size() * meshes.size();
    if (compared > kMaxCompared) return false;
    // A name in the wrong case is meant all the same: mesh-case-mismatch tells of it.
    *bytes = lowered(*bytes);
    const auto is_named = [&](const std::string& mesh) {
      return bytes->find(lowered(file_name(mesh))) != std::string::npos;
    };
    meshes.erase(std::remove_if(meshes.begin(), meshes.end(), is_named), meshes.end());
  }
  return true;
}

void check(const model::Root& root, Context& context) {
  const std::string top(context.folder());
  const std::vector<std::string> files = files_below(top, context.disk());
  std::vector<std::string> meshes = meshes_among(files);
  const std::size_t all = meshes.size();
  // A folder that uses none of its files keeps them for other models.
  if (!leave_unnamed(files, context.disk(), meshes) || meshes.empty() || meshes.size() == all)
    return;
  constexpr std::size_t kListed = 3;
  std::string names;
  for (std::size_t i = 0; i < meshes.size() && i < kListed; ++i) {
    names += (i > 0 ? ", " : "") + ("'" + relative_path(top, meshes[i]) + "'");
  }
  if (meshes.size() > kListed) names += ", …";
  const std::string count = std::to_string(meshes.size());
  context.report(
      {.where = root.site.name,
       .message =
           (meshes.size() == 1 ? "no file of the model names " + names
                               : count + " meshes are named by no file of the model: " + names)});
}

Rule rule() {
  return {
      .name = "mesh-unreferenced",
      .severity = Severity::kInfo,
      .formats = Formats::kModelConfig,
      .summary = "a mesh lies in the folder of a model that does not use it",
      .why = "It is copied and downloaded with the model for nothing, or the model should use it "
             "and has its name wrong.",
      .what_to_do = "Remove the file, unless another model refers to it. A file counts as used "
                    "when its name is in any text of the folder: an .sdf, a xacro file, a script.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::mesh_unreferenced
