// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/uri.h>

#include <cstdint>
#include <string_view>
#include <utility>

#include <rigor/read/values.h>
#include <rigor/text/disk.h>
#include <rigor/text/path.h>
#include <rigor/xml/document.h>

namespace rigor::convert {
namespace {

/// Folders above a mesh that are examined for a package.xml or model.config, as the resolver does.
constexpr int kMaxFoldersAbove = 16;

/// Larger manifests are not read for their names.
constexpr std::uint64_t kMaxManifestBytes = std::uint64_t{1} << 20U;

std::string manifest_name(const Disk& disk, const std::string& path) {
  const ReadResult manifest = disk.read(path, kMaxManifestBytes);
  if (!manifest.bytes) return {};
  const xml::Document document = xml::parse(*manifest.bytes, kNoSource);
  const auto name = document.root() ? document.root()->child("name") : std::nullopt;
  return name ? std::string(read::trimmed(name->text())) : std::string();
}

/// A package is named by its manifest, a model by its folder, as `model://` has it; by its
/// model.config only where the path does not tell the folder's name.
std::string package_name_of(const Disk& disk, const std::string& folder) {
  const std::string package = join_path(folder, "package.xml");
  if (disk.kind(package) == PathKind::kFile) return manifest_name(disk, package);
  const std::string config = join_path(folder, "model.config");
  if (disk.kind(config) != PathKind::kFile) return {};
  const std::string_view name = file_name(folder);
  if (!name.empty() && name != "." && name != "..") return std::string(name);
  const std::string title = manifest_name(disk, config);
  return title.find_first_of(" /") == std::string::npos ? title : std::string();
}

/// `package://…` for a file in the folder of a package or model; nothing for one that is in none.
std::optional<std::string> package_uri(const Disk& disk, const std::string& package,
                                       const std::string& file) {
  const std::string path = normalize_path(file);
  std::string folder(parent_path(path));
  for (int i = 0; i < kMaxFoldersAbove; ++i) {
    const std::string name = package_name_of(disk, folder);
    if (!name.empty()) {
      const std::size_t inside = folder == "." ? 0 : folder.size() + 1;
      return "package://" + (package.empty() ? name : package) + '/' + path.substr(inside);
    }
    const std::string above(parent_path(folder));
    if (above == folder || file_name(folder) == "..") break;
    folder = above;
  }
  return std::nullopt;
}

/// `model://M/p` with its scheme, or its model, exchanged.
std::string with_package(std::string_view uri, const std::string& package) {
  std::string_view rest = uri.substr(uri.find("://") + 3);
  if (package.empty()) return "package://" + std::string(rest);
  const std::size_t slash = rest.find('/');
  rest = slash == std::string_view::npos ? std::string_view() : rest.substr(slash);
  return "package://" + package + std::string(rest);
}

std::string_view scheme_of(std::string_view uri) {
  const std::size_t colon = uri.find("://");
  return colon == std::string_view::npos ? std::string_view() : uri.substr(0, colon);
}

/// A URI of a path that is not whole means the same only to who looks from the same folder.
bool names_place(std::string_view uri) {
  const std::string_view scheme = scheme_of(uri);
  if (scheme.empty()) return is_absolute(uri);
  return scheme != "file" || is_absolute(uri.substr(7));
}

std::string with_policy(const UrdfDraft& draft, const std::string& uri,
                        const std::optional<std::string>& file) {
  const MeshUri& policy = draft.options.mesh_uri;
  const std::string_view scheme = scheme_of(uri);
  switch (policy.kind) {
    case MeshUri::Kind::kKeep: return uri;
    case MeshUri::Kind::kFile: return file ? file_uri(draft.source, *file).value_or(uri) : uri;
    case MeshUri::Kind::kPackage: break;
  }
  if (scheme == "model") return with_package(uri, policy.package);
  if (scheme.empty() && is_absolute(uri)) return "file://" + uri;
  if (names_place(uri) || !file) return uri;
  return package_uri(draft.source.resolver.disk(), policy.package, *file).value_or(uri);
}

/// Whether it leads to the file from where the result will stand.
bool leads_there(const Source& source, const std::string& uri, const std::string& file) {
  const auto path = source.resolver.resolve(uri, source.out).path;
  return path && whole_path(source, *path) == whole_path(source, file);
}

/// Whether it has the name of the ROS package that the file is in.
bool names_ros_package(const Disk& disk, std::string_view uri, const std::string& file) {
  const std::string_view scheme = scheme_of(uri);
  if (scheme != "package" && scheme != "model") return false;
  std::string_view name = uri.substr(scheme.size() + 3);
  name = name.substr(0, name.find('/'));
  std::string folder(parent_path(normalize_path(file)));
  for (int i = 0; i < kMaxFoldersAbove; ++i) {
    const std::string manifest = join_path(folder, "package.xml");
    if (disk.kind(manifest) == PathKind::kFile) return manifest_name(disk, manifest) == name;
    const std::string above(parent_path(folder));
    if (above == folder || file_name(folder) == "..") break;
    folder = above;
  }
  return false;
}

}  // namespace

PlacedUri placed_uri(const Source& source, std::string uri, const std::string& file,
                     UriChoice choice) {
  if (source.out.empty() || leads_there(source, uri, file)) return {std::move(uri)};
  if (choice == UriChoice::kOurs && !names_ros_package(source.resolver.disk(), uri, file)) {
    std::string from_out =
        relative_path(parent_path(whole_path(source, source.out)), whole_path(source, file));
    if (is_absolute(from_out)) from_out = "file://" + from_out;
    if (leads_there(source, from_out, file)) return {std::move(from_out)};
  }
  return {std::move(uri), false};
}

std::string whole_path(const Source& source, const std::string& path) {
  return join_path(source.working_folder, path);
}

std::optional<std::string> file_uri(const Source& source, const std::string& file) {
  const std::string whole = whole_path(source, file);
  return is_absolute(whole) ? std::optional("file://" + whole) : std::nullopt;
}

std::string path_of(const Source& source, SourceId id) {
  for (const model::Include& include : source.root.includes) {
    if (id == source.root.source) break;
    if (include.loaded && source.root[include.loaded].site.span.source == id) return include.path;
  }
  return source.path;
}

std::optional<std::string> file_of(const Source& source, const model::Field<std::string>& uri) {
  if (uri.value.empty() || uri.span.nowhere()) return std::nullopt;
  return source.resolver.resolve(uri.value, path_of(source, uri.span.source)).path;
}

std::string urdf_uri(UrdfDraft& draft, const model::Field<std::string>& uri,
                     const std::string& subject) {
  const std::string_view scheme = scheme_of(uri.value);
  const bool remote = scheme == "http" || scheme == "https";
  const auto file = file_of(draft.source, uri);
  const MeshUri& policy = draft.options.mesh_uri;
  PlacedUri placed{with_policy(draft, uri.value, file)};
  if (file) {
    const bool chosen = policy.kind == MeshUri::Kind::kKeep || !policy.package.empty();
    placed = placed_uri(draft.source, std::move(placed.uri), *file,
                        chosen ? UriChoice::kUsers : UriChoice::kOurs);
  }
  const std::string& result = placed.uri;
  const auto tell = [&](NoteKind kind, Outcome outcome) {
    draft.ledger.take(uri, outcome);
    draft.ledger.note({.kind = kind,
                       .outcome = outcome,
                       .where = uri.span,
                       .subject = subject,
                       .written = uri.value,
                       .instead = result});
  };
  if (result != uri.value) {
    tell(NoteKind::kUri, Outcome::kRewritten);
  } else if (policy.kind != MeshUri::Kind::kKeep &&
             (remote || !names_place(result) || scheme == "model")) {
    tell(NoteKind::kUri, Outcome::kCarried);
  }
  if (!file && !remote) tell(NoteKind::kUriNotFound, Outcome::kConverted);
  if (!placed.found) tell(NoteKind::kUriElsewhere, Outcome::kConverted);
  draft.ledger.take(uri);
  return result;
}

}  // namespace rigor::convert
