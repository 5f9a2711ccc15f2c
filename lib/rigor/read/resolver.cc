// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/resolver.h>

#include <algorithm>
#include <array>

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

/// The value of `<name>` in a package.xml; found as text, because only this one matters here.
std::string package_name(const std::string& bytes) {
  const std::size_t open = bytes.find("<name>");
  const std::size_t close = bytes.find("</name>", open);
  if (open == std::string::npos || close == std::string::npos) return {};
  std::string name = bytes.substr(open + 6, close - open - 6);
  const auto is_space = [](char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; };
  name.erase(std::remove_if(name.begin(), name.end(), is_space), name.end());
  return name;
}

/// Largest package.xml that is read for its name.
constexpr std::uint64_t kMaxPackageXml = std::uint64_t{1} << 20U;

/// Folders above a file that are looked at for a package.xml or a neighbouring model.
constexpr int kMaxAncestors = 16;

constexpr std::string_view kConfiguredOrigin = "rigor.toml";

/// The folder above a path, or the path itself at the top.
std::string above(const std::string& path) {
  if (path == "." || file_name(path) == "..") return normalize_path(path + "/..");
  return std::string(parent_path(path));
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
  add(paths.ros, "ROS_PACKAGE_PATH");
  add(paths.ros, "AMENT_PREFIX_PATH", "share");
  if (const std::string home = variable("HOME"); !home.empty()) {
    paths.environment.push_back({join_path(home, ".gazebo/models"), "~/.gazebo/models"});
    paths.fuel_cache = join_path(home, ".gz/fuel");
  }
  if (const std::string cache = variable("GZ_FUEL_CACHE_PATH"); !cache.empty()) {
    paths.fuel_cache = cache;
  }
  return paths;
}

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
    try_path(join_path(parent_path(file), rest), "beside the file", result);
    if (!result.path && !is_absolute(rest)) resolve_model(rest, file, result);
  }
  if (!result.path) find_other_case(result);
  return result;
}

const ConfiguredPaths* Resolver::configured(std::string_view file) const {
  return paths_.configured ? paths_.configured(file) : nullptr;
}

void Resolver::try_path(std::string path, std::string_view origin, Resolution& result) const {
  if (result.path) return;
  const auto known = [&path](const Tried& tried) { return tried.path == path; };
  if (std::any_of(result.tried.begin(), result.tried.end(), known)) return;
  const PathKind kind = disk_.kind(path);
  result.tried.push_back({path, std::string(origin)});
  if (kind == PathKind::kFile || kind == PathKind::kFolder) result.path = std::move(path);
}

void Resolver::resolve_model(std::string_view rest, std::string_view file,
                             Resolution& result) const {
  for (const SearchPath& path : paths_.given) {
    try_path(join_path(path.folder, rest), path.origin, result);
  }
  if (const ConfiguredPaths* paths = result.path ? nullptr : configured(file)) {
    for (const std::string& path : paths->folders) {
      try_path(join_path(path, rest), kConfiguredOrigin, result);
    }
  }
  // The folder of the model that the file belongs to, and the models beside it.
  std::string folder(parent_path(file));
  for (int i = 0; i < kMaxAncestors && !result.path; ++i) {
    const std::string parent = above(folder);
    if (disk_.kind(join_path(folder, "model.config")) == PathKind::kFile) {
      try_path(join_path(parent, rest), "neighbour of the model's folder", result);
      break;
    }
    if (parent == folder || folder == "/") break;
    folder = parent;
  }
  // A world belongs to no model: what lies around it, as in `worlds/` beside `models/`.
  const std::string beside(parent_path(file));
  for (const std::string& around : {beside, above(beside), join_path(above(beside), "models")}) {
    try_path(join_path(around, rest), "around the file's folder", result);
  }
  for (const SearchPath& path : paths_.environment) {
    try_path(join_path(path.folder, rest), path.origin, result);
  }
  for (const SearchPath& path : paths_.ros) {
    try_path(join_path(path.folder, rest), path.origin, result);
  }
}

void Resolver::resolve_package(std::string_view rest, std::string_view file,
                               Resolution& result) const {
  const std::size_t slash = std::min(rest.find('/'), rest.size());
  const std::string name(rest.substr(0, slash));
  const std::string_view inside = slash < rest.size() ? rest.substr(slash + 1) : "";
  if (const auto found = paths_.packages.find(name); found != paths_.packages.end()) {
    try_path(join_path(found->second, inside), "--package", result);
  }
  for (const SearchPath& path : paths_.given) {
    try_path(join_path(path.folder, rest), path.origin, result);
  }
  if (const ConfiguredPaths* paths = result.path ? nullptr : configured(file)) {
    if (const auto found = paths->packages.find(name); found != paths->packages.end()) {
      try_path(join_path(found->second, inside), kConfiguredOrigin, result);
    }
    for (const std::string& path : paths->folders) {
      try_path(join_path(path, rest), kConfiguredOrigin, result);
    }
  }
  std::string folder(parent_path(file));
  for (int i = 0; i < kMaxAncestors && !result.path; ++i) {
    const std::string manifest = join_path(folder, "package.xml");
    const ReadResult read = disk_.read(manifest, kMaxPackageXml);
    if (read.bytes && package_name(*read.bytes) == name) {
      try_path(join_path(folder, inside), "package.xml of the file's package", result);
      break;
    }
    // A folder of the package's name, or one beside an ancestor: a workspace's `src`.
    if (file_name(folder) == name) {
      try_path(join_path(folder, inside), "folder of the package's name", result);
    }
    const std::string parent = above(folder);
    try_path(join_path(join_path(parent, name), inside), "beside the file's folders", result);
    if (parent == folder || folder == "/") break;
    folder = parent;
  }
  for (const SearchPath& path : paths_.ros) {
    try_path(join_path(path.folder, rest), path.origin, result);
  }
  for (const SearchPath& path : paths_.environment) {
    try_path(join_path(path.folder, rest), path.origin, result);
  }
}

void Resolver::resolve_remote(std::string_view uri, Resolution& result) const {
  // https://fuel.gazebosim.org/1.0/OWNER/models/NAME lies in the cache as
  // fuel.gazebosim.org/OWNER/models/NAME/VERSION, in lower case.
  result.remote = true;
  if (paths_.fuel_cache.empty()) return;
  std::string path(uri.substr(uri.find("://") + 3));
  const std::size_t version = path.find("/1.0/");
  if (version != std::string::npos) path.erase(version, 4);
  for (char& c : path) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
  }
  const std::string folder = join_path(paths_.fuel_cache, path);
  const std::vector<std::string> versions = disk_.list(folder);
  const std::string newest = versions.empty() ? folder : join_path(folder, versions.back());
  try_path(newest, "Fuel cache", result);
}

void Resolver::find_other_case(Resolution& result) const {
  for (const Tried& tried : result.tried) {
    const std::string name = other_case(disk_, tried.path);
    if (name.empty()) continue;
    result.other_case = join_path(parent_path(tried.path), name);
    return;
  }
}

}  // namespace rigor::read
