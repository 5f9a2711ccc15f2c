// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/package_manifest.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

#include <rigor/read/values.h>
#include <rigor/text/path.h>
#include <rigor/xml/document.h>

namespace rigor::read {
namespace {

constexpr std::uint64_t kMaxPackageXml = std::uint64_t{1} << 20U;

/// Of a list "${prefix}/models:${prefix}/..:/other" those that begin at the package.
void add_folders(std::string_view list, const std::string& package,
                 std::vector<std::string>& folders) {
  constexpr std::string_view kPrefix = "${prefix}";
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(':'), list.size());
    const std::string_view place = trimmed(list.substr(0, end));
    list.remove_prefix(std::min(end + 1, list.size()));
    if (!place.starts_with(kPrefix)) continue;
    folders.push_back(normalize_path(package + std::string(place.substr(kPrefix.size()))));
  }
}

}  // namespace

std::optional<PackageManifest> package_manifest(const Disk& disk, const std::string& folder) {
  const std::string path = join_path(folder, "package.xml");
  if (disk.kind(path) != PathKind::kFile) return std::nullopt;
  const ReadResult read = disk.read(path, kMaxPackageXml);
  if (!read.bytes) return std::nullopt;
  PackageManifest manifest;
  const xml::Document document = xml::parse(*read.bytes, kNoSource);
  const auto root = document.root();
  if (!root) return manifest;
  if (const auto name = root->child("name")) manifest.name = trimmed(name->text());
  for (const std::string_view attribute : {"gazebo_model_path", "gazebo_media_path"}) {
    for (const xml::Element block : root->children()) {
      if (block.name() != "export") continue;
      for (const xml::Element element : block.children()) {
        const auto paths = element.attribute(attribute);
        if (paths) add_folders(paths->value(), folder, manifest.gazebo_folders);
      }
    }
  }
  return manifest;
}

}  // namespace rigor::read
