// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/package_index.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include <rigor/read/package_manifest.h>
#include <rigor/text/path.h>

namespace rigor::read {
namespace {

/// Below a workspace's folder: packages lie at depth 1 to 4, `src/vendor/group/package`.
constexpr int kMaxPackageDepth = 5;

/// Folders of one tree that are listed. The largest repositories of robots have 3,000.
constexpr int kMaxPackageFolders = 20'000;

/// Files by which build tools are told to leave a folder alone.
constexpr std::string_view kIgnoreMarkers[] = {"AMENT_IGNORE", "CATKIN_IGNORE", "COLCON_IGNORE"};

/// What build tools make beside `src`.
constexpr std::string_view kBuilt[] = {"build", "install", "devel"};

bool is_package(const Disk& disk, const std::string& folder) {
  return disk.kind(join_path(folder, "package.xml")) == PathKind::kFile;
}

bool is_folder(const Disk& disk, const std::string& path) {
  return disk.kind(path) == PathKind::kFolder;
}

bool has_built(const Disk& disk, const std::string& folder) {
  return std::any_of(std::begin(kBuilt), std::end(kBuilt), [&](std::string_view name) {
    return is_folder(disk, join_path(folder, name));
  });
}

/// The folder `src` of a workspace, as which a folder counts or which is in it; empty where there is none.
std::string sources_of(const Disk& disk, const std::string& folder) {
  if (file_name(folder) == "src")
    return is_package(disk, std::string(parent_path(folder))) ? std::string() : folder;
  std::string sources = join_path(folder, "src");
  const bool is_workspace =
      is_folder(disk, sources) && has_built(disk, folder) && !is_package(disk, folder);
  return is_workspace ? sources : std::string();
}

std::size_t shared_folders(std::string_view a, std::string_view b) {
  std::size_t count = 0;
  std::size_t at = 0;
  for (; at < a.size() && at < b.size() && a[at] == b[at]; ++at) count += a[at] == '/' ? 1 : 0;
  const bool ends = (at == a.size() || a[at] == '/') && (at == b.size() || b[at] == '/');
  return count + (ends ? 1 : 0);
}

}  // namespace

std::string tree_of(const Disk& disk, const std::string& folder) {
  std::string at = folder;
  std::string package;
  for (int up = 0; up < kMaxAncestors; ++up) {
    if (disk.kind(join_path(at, ".git")) != PathKind::kMissing) return at;
    if (is_package(disk, at)) package = at;
    std::string above(parent_path(at));
    if (above == at || above.empty()) break;
    at = std::move(above);
  }
  return package.empty() ? folder : std::string(parent_path(package));
}

std::vector<std::string> trees_around(const Disk& disk, const std::string& folder) {
  std::vector<std::string> trees{tree_of(disk, folder)};
  const auto add = [&trees](std::string tree) {
    if (tree.empty() || std::count(trees.begin(), trees.end(), tree) > 0) return;
    trees.push_back(std::move(tree));
  };
  bool in_submodule = true;  // so far no repository's own mark was met, which is a folder
  std::string at = folder;
  for (int up = 0; up < kMaxAncestors; ++up) {
    const PathKind mark = disk.kind(join_path(at, ".git"));
    if (mark != PathKind::kMissing && in_submodule) add(at);
    in_submodule = in_submodule && mark != PathKind::kFolder;
    add(sources_of(disk, at));
    std::string above(parent_path(at));
    if (above == at || above.empty()) break;
    at = std::move(above);
  }
  return trees;
}

PackageIndex::PackageIndex(const Disk& disk, std::vector<std::string> named)
    : disk_(disk), named_(std::move(named)) {}

void PackageIndex::gather(const std::string& folder, int depth, Folders& into) {
  if (++listed_ > kMaxPackageFolders) return;
  const std::vector<std::string> names = disk_.list(folder);
  const auto holds = [&names](std::string_view name) {
    return std::binary_search(names.begin(), names.end(), name);
  };
  if (depth > 0 && std::any_of(std::begin(kIgnoreMarkers), std::end(kIgnoreMarkers), holds)) return;
  if (holds("package.xml")) {
    const auto manifest = package_manifest(disk_, folder);
    if (manifest && !manifest->name.empty()) into[manifest->name].push_back(folder);
  }
  if (depth == kMaxPackageDepth) return;
  for (const std::string& name : names) {
    if (name.starts_with('.') || name == "build" || name == "install" || name == "log") continue;
    if (is_model_data(name)) continue;  // a file, and most of what is there
    const std::string inside = join_path(folder, name);
    if (is_folder(disk_, inside)) gather(inside, depth + 1, into);
  }
}

const PackageIndex::Folders& PackageIndex::packages_below(const std::string& root) {
  const auto [found, is_new] = by_root_.try_emplace(root);
  if (is_new) {
    listed_ = 0;
    gather(root, 0, found->second);
  }
  return found->second;
}

const std::vector<std::string>& PackageIndex::roots_around(const std::string& folder) {
  const auto [known, is_new] = roots_.try_emplace(folder);
  if (is_new) {
    known->second = trees_around(disk_, folder);
    known->second.insert(known->second.end(), named_.begin(), named_.end());
  }
  return known->second;
}

std::optional<std::string> PackageIndex::find(std::string_view name, const std::string& root,
                                              const std::string& folder) {
  const Folders& packages = packages_below(root);
  const auto found = packages.find(name);
  if (found == packages.end()) return std::nullopt;
  const std::vector<std::string>& folders = found->second;
  return *std::max_element(folders.begin(), folders.end(), [&](const auto& a, const auto& b) {
    return shared_folders(a, folder) < shared_folders(b, folder);
  });
}

std::optional<std::string> PackageIndex::find_around(std::string_view name,
                                                     const std::string& folder) {
  const std::lock_guard lock(mutex_);
  for (const std::string& root : roots_around(folder)) {
    if (auto found = find(name, root, folder)) return found;
  }
  return std::nullopt;
}

std::optional<std::string> PackageIndex::find_below(std::string_view name, const std::string& root,
                                                    const std::string& folder) {
  const std::lock_guard lock(mutex_);
  return find(name, root, folder);
}

std::vector<std::string> PackageIndex::searched(const std::string& folder) {
  const std::lock_guard lock(mutex_);
  return roots_around(folder);
}

}  // namespace rigor::read
