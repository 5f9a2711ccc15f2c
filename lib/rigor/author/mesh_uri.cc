// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/mesh_uri.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <rigor/read/package_manifest.h>
#include <rigor/text/disk.h>
#include <rigor/text/path.h>

namespace rigor::author {
namespace {

std::vector<std::string_view> parts_of(std::string_view path) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin < path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    const std::string_view part = path.substr(begin, end - begin);
    if (!part.empty() && part != ".") parts.push_back(part);
    begin = end + 1;
  }
  return parts;
}

std::string joined(const std::vector<std::string_view>& parts, std::size_t from) {
  std::string path;
  for (std::size_t i = from; i < parts.size(); ++i) {
    path += (path.empty() ? "" : "/") + std::string(parts[i]);
  }
  return path;
}

std::size_t common(const std::vector<std::string_view>& a, const std::vector<std::string_view>& b) {
  return static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first -
                                  a.begin());
}

/// Once there is such a file: those that are tried before it are not there.
bool leads_to(const read::Resolver& resolver, const std::string& uri, const std::string& file,
              const std::string& path) {
  const read::Resolution found = resolver.resolve(uri, file);
  return std::any_of(found.tried.begin(), found.tried.end(),
                     [&path](const read::Tried& tried) { return tried.path == path; });
}

/// The URI with the parts in which the paths differ exchanged.
std::optional<std::string> with_last_parts(std::string_view uri, std::string_view from,
                                           std::string_view to) {
  const std::vector<std::string_view> old_parts = parts_of(from);
  const std::vector<std::string_view> new_parts = parts_of(to);
  // A file's own name differs even where the folder of the one has the name of the other.
  const std::size_t same =
      std::min({common(old_parts, new_parts), old_parts.size() - 1, new_parts.size() - 1});
  const std::string tail = joined(old_parts, same);
  if (!uri.ends_with(tail)) return std::nullopt;
  const std::string_view head = uri.substr(0, uri.size() - tail.size());
  if (!head.empty() && !head.ends_with('/')) return std::nullopt;
  return std::string(head) + joined(new_parts, same);
}

std::string seen_from(const std::string& file, const std::string& mesh) {
  return relative_path(parent_path(file), mesh);
}

/// The nearest folder at or above the file's that holds a file of this name.
std::optional<std::string> folder_with(const Disk& disk, const std::string& file,
                                       std::string_view name) {
  std::string folder = normalize_path(parent_path(file));
  for (int i = 0; i < read::kMaxAncestors; ++i) {
    if (disk.kind(join_path(folder, name)) == PathKind::kFile) return folder;
    std::string above = enclosing_folder(folder);
    if (above == folder) break;
    folder = std::move(above);
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> renamed_uri(const read::Resolver& resolver, const std::string& uri,
                                       const std::string& file, const std::string& from,
                                       const std::string& to) {
  std::vector<std::string> candidates;
  if (auto renamed = with_last_parts(uri, normalize_path(from), normalize_path(to))) {
    candidates.push_back(*std::move(renamed));
  }
  const bool is_path = uri.find("://") == std::string::npos;
  if (is_path) candidates.push_back(seen_from(file, to));
  if (uri.starts_with("file://") && is_absolute(to)) candidates.push_back("file://" + to);
  for (std::string& candidate : candidates) {
    if (leads_to(resolver, candidate, file, normalize_path(to))) return std::move(candidate);
  }
  return std::nullopt;
}

NewUri new_uri(const read::Resolver& resolver, model::Format format, const std::string& file,
               const std::string& mesh) {
  const bool urdf = format == model::Format::kUrdf;
  const auto folder = folder_with(resolver.disk(), file, urdf ? "package.xml" : "model.config");
  if (!folder) return {seen_from(file, mesh), std::nullopt};

  NewUri result;
  std::string inside = relative_path(*folder, mesh);
  const bool elsewhere = is_absolute(inside) || inside.starts_with("../") ||
                         join_path(*folder, inside) != normalize_path(mesh);
  if (elsewhere) {
    inside = "meshes/" + std::string(file_name(mesh));
    result.copy = MeshCopy{mesh, join_path(*folder, inside)};
  }
  const std::string path = join_path(*folder, inside);
  const auto package = read::package_manifest(resolver.disk(), *folder);
  const std::string name = urdf && package ? package->name : std::string(file_name(*folder));
  result.uri = std::string(urdf ? "package://" : "model://") + name + '/' + inside;
  const bool named = !name.empty() && name != "." && name != "..";
  if (!named || !leads_to(resolver, result.uri, file, path)) result.uri = seen_from(file, path);
  return result;
}

}  // namespace rigor::author
