// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/resolver.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <rigor/read/package_index.h>
#include <rigor/text/letter_case.h>
#include <rigor/text/path.h>

namespace rigor::read {
namespace {

std::vector<SearchPath> split(const std::string& value, const std::string& origin) {
  std::vector<SearchPath> paths;
  for (std::size_t begin = 0; begin <= value.size();) {
    const std::size_t end = std::min(value.find(':', begin), value.size());
    if (end > begin) paths.push_back({value.substr(begin, end - begin), origin});
    begin = end + 1;
  }
  return paths;
}

constexpr std::string_view kConfiguredOrigin = "rigor.toml";

constexpr std::string_view kRosPath = "ROS_PACKAGE_PATH";
constexpr std::string_view kAmentPath = "AMENT_PREFIX_PATH";

std::vector<std::string> absolute_folders_of(const SearchPaths& paths) {
  std::vector<std::string> folders;
  for (const std::string& folder : paths.named)
    folders.push_back(join_path(paths.templates.working_folder, folder));
  return folders;
}

/// How many folders up a path of nothing but ".." leads, which has no end; 0 of any other path.
std::ptrdiff_t folders_up(std::string_view path) {
  return file_name(path) == ".." ? std::count(path.begin(), path.end(), '/') + 1 : 0;
}

/// The greatest of the names that are whole numbers; empty when none is, as in a folder of one version.
std::string newest_version(const std::vector<std::string>& names) {
  std::string newest;
  for (const std::string& name : names) {
    if (name.empty() || name.find_first_not_of("0123456789") != std::string::npos) continue;
    const auto size = [](const std::string& number) { return number.size(); };
    if (std::pair(size(name), name) > std::pair(size(newest), newest)) newest = name;
  }
  return newest;
}

}  // namespace

SearchPaths search_paths_from(const std::function<std::string(const std::string&)>& variable) {
  SearchPaths paths;
  const auto add = [&variable](std::vector<SearchPath>& list, const std::string& name,
                               const std::string& below = {}) {
    for (SearchPath& path : split(variable(name), name)) {
      if (!below.empty()) path.folder = join_path(path.folder, below);
      list.push_back(std::move(path));
    }
  };
  for (const char* name : {"GZ_SIM_RESOURCE_PATH", "IGN_GAZEBO_RESOURCE_PATH", "SDF_PATH",
                           "GAZEBO_MODEL_PATH", "GAZEBO_RESOURCE_PATH"}) {
    add(paths.environment, name);
  }
  add(paths.environment, std::string(kRosPath));
  add(paths.environment, std::string(kAmentPath), "share");
  if (const std::string home = variable("HOME"); !home.empty()) {
    paths.environment.push_back({join_path(home, ".gazebo/models"), "~/.gazebo/models"});
    paths.fuel_cache = join_path(home, ".gz/fuel");
  }
  if (const std::string cache = variable("GZ_FUEL_CACHE_PATH"); !cache.empty()) {
    paths.fuel_cache = cache;
  }
  return paths;
}

Resolver::Resolver(const Disk& disk, SearchPaths paths)
    : disk_(disk),
      paths_(std::move(paths)),
      index_(std::make_shared<PackageIndex>(disk, absolute_folders_of(paths_))),
      other_case_(std::make_shared<OtherCase>(disk)) {}

Resolution Resolver::resolve(std::string_view uri, std::string_view file) const {
  Resolution result;
  const std::size_t colon = uri.find("://");
  if (colon != std::string_view::npos) result.scheme = uri.substr(0, colon);
  const std::string_view rest = colon == std::string_view::npos ? uri : uri.substr(colon + 3);
  if (result.scheme == "http" || result.scheme == "https") {
    resolve_remote(uri, result);
  } else if (result.scheme == "model") {
    resolve_model(rest, file, result);
  } else if (result.scheme == "package") {
    resolve_package(rest, file, result);
  } else {
    // A path: beside the file first, then wherever models are.
    const bool found = try_path(join_path(parent_path(file), rest), "beside the file", result);
    if (!found && !is_absolute(rest)) resolve_model(rest, file, result);
  }
  if (!result.path) find_other_case(result);
  return result;
}

const ConfiguredPaths* Resolver::configured(std::string_view file) const {
  return paths_.configured ? paths_.configured(file) : nullptr;
}

bool Resolver::try_path(std::string path, std::string_view origin, Resolution& result) const {
  const auto known = [&path](const Tried& tried) { return tried.path == path; };
  if (std::any_of(result.tried.begin(), result.tried.end(), known)) return false;
  const PathKind kind = disk_.kind(path);
  const bool found = kind == PathKind::kFile || kind == PathKind::kFolder;
  result.tried.push_back({path, std::string(origin)});
  if (found) result.path = std::move(path);
  return found;
}

bool Resolver::try_folders(const std::vector<SearchPath>& folders, std::string_view rest,
                           Resolution& result) const {
  return std::any_of(folders.begin(), folders.end(), [&](const SearchPath& path) {
    return try_path(join_path(path.folder, rest), path.origin, result);
  });
}

bool Resolver::try_configured(const ConfiguredPaths& paths, std::string_view rest,
                              Resolution& result) const {
  return std::any_of(paths.folders.begin(), paths.folders.end(), [&](const std::string& path) {
    return try_path(join_path(path, rest), kConfiguredOrigin, result);
  });
}

void Resolver::resolve_model(std::string_view rest, std::string_view file,
                             Resolution& result) const {
  if (try_folders(paths_.given, rest, result)) return;
  if (const ConfiguredPaths* paths = configured(file)) {
    if (try_configured(*paths, rest, result)) return;
  }
  // The folder of the model that the file belongs to, and the models beside it.
  std::string folder(parent_path(file));
  for (int i = 0; i < kMaxAncestors; ++i) {
    std::string parent = enclosing_folder(folder);
    if (disk_.kind(join_path(folder, "model.config")) == PathKind::kFile) {
      if (try_path(join_path(parent, rest), "neighbor of the model's folder", result)) return;
      break;
    }
    if (parent == folder || folder == "/") break;
    folder = std::move(parent);
  }
  // A world belongs to no model: what lies around it, as in `worlds/` beside `models/`.
  const std::string beside(parent_path(file));
  const std::string around = enclosing_folder(beside);
  for (const std::string& place : {beside, around, join_path(around, "models")}) {
    if (try_path(join_path(place, rest), "around the file's folder", result)) return;
  }
  if (result.scheme == "model" &&
      try_path(join_path(join_path(beside, "models"), rest), "around the file's folder", result)) {
    return;
  }
  // The name of a model alone, as includes have it, is no path to a mesh.
  const bool is_name = result.scheme.empty() && rest.find_first_of("/.") == rest.npos;
  if (is_name || result.scheme == "model" || result.scheme == "file") {
    for (const std::string& place : package_folders(beside)) {
      if (try_path(join_path(place, rest), "the file's package", result)) return;
    }
  }
  try_folders(paths_.environment, rest, result);
}

const std::optional<PackageManifest>& Resolver::manifest(const std::string& folder) const {
  const std::lock_guard lock(packages_->mutex);
  const auto [known, is_new] = packages_->manifests.try_emplace(folder);
  if (is_new) known->second = package_manifest(disk_, folder);
  return known->second;
}

std::vector<std::string> Resolver::find_package_folders(const std::string& folder) const {
  std::vector<std::string> places;
  if (const std::optional<PackageManifest>& package = manifest(folder)) {
    places = package->gazebo_folders;
    places.push_back(join_path(folder, "models"));
    return places;
  }
  const std::string parent = enclosing_folder(folder);
  if (parent == folder || folders_up(folder) == kMaxAncestors) return places;
  const std::vector<std::string>& others = package_folders(parent);
  if (others.empty()) return places;
  places.push_back(join_path(folder, "models"));
  places.insert(places.end(), others.begin(), others.end());
  return places;
}

const std::vector<std::string>& Resolver::package_folders(const std::string& folder) const {
  {
    const std::lock_guard lock(packages_->mutex);
    const auto known = packages_->folders.find(folder);
    if (known != packages_->folders.end()) return known->second;
  }
  std::vector<std::string> places = find_package_folders(folder);
  const std::lock_guard lock(packages_->mutex);
  return packages_->folders.try_emplace(folder, std::move(places)).first->second;
}

void Resolver::resolve_package(std::string_view rest, std::string_view file,
                               Resolution& result) const {
  const std::size_t slash = std::min(rest.find('/'), rest.size());
  const std::string name(rest.substr(0, slash));
  const std::string_view inside = slash < rest.size() ? rest.substr(slash + 1) : "";
  const auto try_package = [&](const std::map<std::string, std::string>& packages,
                               std::string_view origin) {
    const auto found = packages.find(name);
    return found != packages.end() && try_path(join_path(found->second, inside), origin, result);
  };
  if (try_package(paths_.packages, "--package")) return;
  if (try_folders(paths_.given, rest, result)) return;
  if (const ConfiguredPaths* paths = configured(file)) {
    if (try_package(paths->packages, kConfiguredOrigin)) return;
    if (try_configured(*paths, rest, result)) return;
  }
  if (try_package_above(name, inside, file, result)) return;
  if (try_package_around(name, inside, file, result)) return;
  if (try_folders(paths_.environment, rest, result)) return;
  try_below_environment(name, inside, file, result);
}

bool Resolver::try_package_above(const std::string& name, std::string_view inside,
                                 std::string_view file, Resolution& result) const {
  std::string folder(parent_path(file));
  for (int i = 0; i < kMaxAncestors; ++i) {
    const std::optional<PackageManifest>& package = manifest(folder);
    if (package && package->name == name) {
      return try_path(join_path(folder, inside), "package.xml of the file's package", result);
    }
    // A folder of the package's name, or one beside an ancestor: a workspace's `src`.
    if (file_name(folder) == name &&
        try_path(join_path(folder, inside), "folder of the package's name", result)) {
      return true;
    }
    std::string parent = enclosing_folder(folder);
    if (try_path(join_path(join_path(parent, name), inside), "beside the file's folders", result)) {
      return true;
    }
    if (parent == folder || folder == "/") break;
    folder = std::move(parent);
  }
  return false;
}

bool Resolver::try_package_around(const std::string& name, std::string_view inside,
                                  std::string_view file, Resolution& result) const {
  const std::string& here = paths_.templates.working_folder;
  const std::string folder(parent_path(join_path(here, file)));
  // As the file's path is written: below the folder of the run it stays relative.
  const auto written = [&](const std::string& path) {
    return is_absolute(file) || here.empty() ? path : relative_path(here, path);
  };
  if (const auto found = index_->find_around(name, folder)) {
    return try_path(join_path(written(*found), inside), "a package.xml around the file", result);
  }
  for (const std::string& root : index_->searched(folder)) {
    result.tried.push_back(
        {join_path(written(root), "**/package.xml"), "none gives the package's name"});
  }
  return false;
}

bool Resolver::try_below_environment(const std::string& name, std::string_view inside,
                                     std::string_view file, Resolution& result) const {
  return std::any_of(
      paths_.environment.begin(), paths_.environment.end(), [&](const SearchPath& path) {
        if (path.origin != kRosPath) return false;
        const auto found = index_->find_below(name, path.folder, std::string(parent_path(file)));
        return found && try_path(join_path(*found, inside), kRosPath, result);
      });
}

std::optional<std::string> Resolver::package_folder(std::string_view name,
                                                    std::string_view file) const {
  const std::string package(name);
  if (const auto given = paths_.packages.find(package); given != paths_.packages.end())
    return given->second;
  if (const ConfiguredPaths* paths = configured(file)) {
    const auto named = paths->packages.find(package);
    if (named != paths->packages.end()) return named->second;
  }
  const std::string folder(parent_path(file));
  std::string at = folder;
  for (int up = 0; up < kMaxAncestors; ++up) {
    if (const std::optional<PackageManifest>& own = manifest(at)) {
      if (own->name == name) return at;
      break;
    }
    std::string above(parent_path(at));
    if (above == at) break;
    at = std::move(above);
  }
  if (auto found = index_->find_around(name, folder)) return found;
  for (const SearchPath& path : paths_.environment) {
    // The search paths have PREFIX/share, where packages lie.
    std::string share = join_path(path.folder, name);
    if (path.origin == kAmentPath && disk_.kind(share) == PathKind::kFolder) return share;
    if (path.origin != kRosPath) continue;
    if (auto found = index_->find_below(name, path.folder, folder)) return found;
  }
  return std::nullopt;
}

void Resolver::resolve_remote(std::string_view uri, Resolution& result) const {
  // https://fuel.gazebosim.org/1.0/OWNER/models/NAME lies in the cache as
  // fuel.gazebosim.org/OWNER/models/NAME/VERSION, in lower case.
  result.remote = true;
  if (paths_.fuel_cache.empty()) return;
  std::string path(uri.substr(uri.find("://") + 3));
  const std::size_t version = path.find("/1.0/");
  if (version != std::string::npos) path.erase(version, 4);
  const std::string folder = join_path(paths_.fuel_cache, lowered(path));
  const std::string newest = newest_version(disk_.list(folder));
  try_path(newest.empty() ? folder : join_path(folder, newest), "Fuel cache", result);
}

void Resolver::find_other_case(Resolution& result) const {
  for (const Tried& tried : result.tried) {
    result.other_case = other_case_->find(tried.path);
    if (!result.other_case.empty()) return;
  }
}

}  // namespace rigor::read
