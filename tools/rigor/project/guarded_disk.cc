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

/// What is looked for in the folders above a model.
constexpr std::string_view kManifests[] = {".gitignore", "rigor.toml"};

/// Patterns of who works in the repository, which git writes into every clone.
constexpr std::string_view kOwnPatterns = "/.git/info/exclude";

bool is_manifest(std::string_view path) {
  return std::find(std::begin(kManifests), std::end(kManifests), file_name(path)) !=
         std::end(kManifests);
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
  // A link has the name that a repository gave it, by which readers know what it is.
  const std::string real = real_path_of(path);
  if ((is_model_data(real) && is_model_data(path)) || is_manifest(real) ||
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
