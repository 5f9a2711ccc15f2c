// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "project/guarded_disk.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include <rigor/text/path.h>

namespace rigor::tool {
namespace {

constexpr std::string_view kConfined = "lies outside of what --confine names";

/// Of models, meshes, their materials and pictures. Who reads one of them takes its bytes for nothing else.
constexpr std::string_view kReadAnywhere[] = {
    ".3ds",  ".bmp", ".config", ".dae",  ".dds",  ".fbx",  ".gif",   ".glb",   ".gltf", ".hdr",
    ".jpeg", ".jpg", ".mesh",   ".mjcf", ".mtl",  ".obj",  ".ply",   ".png",   ".sdf",  ".srdf",
    ".stl",  ".tga", ".tif",    ".tiff", ".urdf", ".webp", ".world", ".xacro", ".xml",  ".xsdf"};

/// What is looked for in the folders above a model.
constexpr std::string_view kManifests[] = {".gitignore", "rigor.toml"};

/// Patterns of who works in the repository, which git writes into every clone.
constexpr std::string_view kOwnPatterns = "/.git/info/exclude";

template <std::size_t N>
bool is_one_of(const std::string_view (&list)[N], std::string_view name) {
  return std::find(std::begin(list), std::end(list), name) != std::end(list);
}

}  // namespace

bool GuardedDisk::confined_from(const std::string& path) const {
  if (confinement_.empty()) return false;
  const std::string real = real_path_of(path);
  return std::none_of(confinement_.begin(), confinement_.end(),
                      [&real](const std::string& folder) { return lies_below(real, folder); });
}

std::string GuardedDisk::refusal(const std::string& path) const {
  if (confined_from(path)) return std::string(kConfined);
  if (reach_.holds(path)) return {};
  // A link has the name that a repository gave it.
  const std::string real = real_path_of(path);
  if (is_one_of(kReadAnywhere, extension(real)) || is_one_of(kManifests, file_name(real)) ||
      real.ends_with(kOwnPatterns))
    return {};
  return "lies outside of what was named, and is not read: --model-path DIR names its folder";
}

std::unique_ptr<OpenFile> GuardedDisk::open(const std::string& path) const {
  if (!refusal(path).empty()) return nullptr;
  return disk_.open(path);
}

ReadResult GuardedDisk::read(const std::string& path, std::uint64_t max_bytes) const {
  if (disk_.kind(path) == PathKind::kFile) {
    if (std::string why = refusal(path); !why.empty()) return {std::nullopt, std::move(why)};
  } else if (confined_from(path)) {
    return {std::nullopt, std::string(kConfined)};
  }
  return disk_.read(path, max_bytes);
}

PathKind GuardedDisk::kind(const std::string& path) const {
  return confined_from(path) ? PathKind::kMissing : disk_.kind(path);
}

std::vector<std::string> GuardedDisk::list(const std::string& folder) const {
  if (confined_from(folder)) return {};
  return disk_.list(folder);
}

std::string GuardedDisk::obstacle(const std::string& path) const {
  return confined_from(path) ? std::string(kConfined) : disk_.obstacle(path);
}

}  // namespace rigor::tool
