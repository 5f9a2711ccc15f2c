// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/template/package_finder.h>

#include <utility>

#include <rigor/read/package_manifest.h>
#include <rigor/text/path.h>

namespace rigor::read {
namespace {

/// Below a workspace's folder: packages lie at depth 1 to 4, `src/vendor/group/package`.
constexpr int kMaxPackageDepth = 5;

/// Folders of a workspace that are listed. The largest repositories of robots have 3,000.
constexpr int kMaxPackageFolders = 20'000;

bool is_package(const Disk& disk, const std::string& folder) {
  return disk.kind(join_path(folder, "package.xml")) == PathKind::kFile;
}

}  // namespace

PackageFinder::PackageFinder(const Disk& disk, SearchPaths paths)
    : disk_(disk), paths_(std::move(paths)) {}

/// Without a repository's mark, the folder that holds the file's package and others beside it.
std::string PackageFinder::workspace_of(const std::string& folder) const {
  std::string at = folder;
  std::string package;
  for (int up = 0; up < kMaxAncestors; ++up) {
    if (disk_.kind(join_path(at, ".git")) != PathKind::kMissing) return at;
    if (is_package(disk_, at)) package = at;
    const std::string above(parent_path(at));
    if (above == at || above.empty()) break;
    at = above;
  }
  return package.empty() ? folder : std::string(parent_path(package));
}

void PackageFinder::gather(const std::string& folder, int depth, Folders& into) {
  if (++looked_at_ > kMaxPackageFolders) return;
  if (is_package(disk_, folder)) {
    const auto manifest = package_manifest(disk_, folder);
    // The first in the order of paths is it, as for the build tools that refuse a second.
    if (manifest && !manifest->name.empty()) into.emplace(manifest->name, folder);
  }
  if (depth == kMaxPackageDepth) return;
  for (const std::string& name : disk_.list(folder)) {
    if (name.starts_with('.') || name == "build" || name == "install" || name == "log") continue;
    const std::string inside = join_path(folder, name);
    if (disk_.kind(inside) == PathKind::kFolder) gather(inside, depth + 1, into);
  }
}

const PackageFinder::Folders& PackageFinder::packages_near(const std::string& folder) {
  const auto [known, added] = workspaces_.try_emplace(folder);
  if (added) known->second = workspace_of(folder);
  const auto [found, first] = by_workspace_.try_emplace(known->second);
  if (first) {
    looked_at_ = 0;
    gather(known->second, 0, found->second);
  }
  return found->second;
}

std::optional<std::string> PackageFinder::find(std::string_view name, std::string_view file) {
  const std::lock_guard lock(mutex_);
  return search(name, std::string(file));
}

std::optional<std::string> PackageFinder::search(std::string_view name, const std::string& file) {
  const auto given = paths_.packages.find(std::string(name));
  if (given != paths_.packages.end()) return given->second;
  if (const ConfiguredPaths* configured = paths_.configured ? paths_.configured(file) : nullptr) {
    const auto named = configured->packages.find(std::string(name));
    if (named != configured->packages.end()) return named->second;
  }
  const std::string folder(parent_path(file));
  std::string at = folder;
  for (int up = 0; up < kMaxAncestors; ++up) {
    if (is_package(disk_, at)) {
      const auto manifest = package_manifest(disk_, at);
      if (manifest && manifest->name == name) return at;
      break;
    }
    const std::string above(parent_path(at));
    if (above == at) break;
    at = above;
  }
  const Folders& near = packages_near(folder);
  if (const auto found = near.find(name); found != near.end()) return found->second;
  for (const SearchPath& path : paths_.environment) {
    if (path.origin == "AMENT_PREFIX_PATH") {
      // The search paths have PREFIX/share, where packages lie.
      const std::string share = join_path(path.folder, name);
      if (disk_.kind(share) == PathKind::kFolder) return share;
    } else if (path.origin == "ROS_PACKAGE_PATH") {
      Folders below;
      looked_at_ = 0;
      gather(path.folder, 0, below);
      if (const auto found = below.find(name); found != below.end()) return found->second;
    }
  }
  return std::nullopt;
}

}  // namespace rigor::read
