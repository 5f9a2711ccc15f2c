// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// ROS packages, as far as files tell: a folder with a package.xml, whose name is the one written there.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/read/resolver.h>
#include <rigor/read/values.h>
#include <rigor/rules/context.h>
#include <rigor/text/disk.h>
#include <rigor/text/path.h>

namespace rigor::rules {

struct RosPackage {
  std::string folder;
  std::string name;
};

/// The package whose package.xml lies in the folder; nothing when there is none, or it has no name.
inline std::optional<RosPackage> package_in(const std::string& folder, const Context& context) {
  constexpr std::uint64_t kMaxManifest = std::uint64_t{1} << 20U;  // as the resolver reads
  const auto bytes = context.disk().read(join_path(folder, "package.xml"), kMaxManifest).bytes;
  if (!bytes) return std::nullopt;
  constexpr std::string_view kOpen = "<name>";
  const std::size_t open = bytes->find(kOpen);
  const std::size_t close = bytes->find("</name>", open);
  if (open == std::string::npos || close == std::string::npos) return std::nullopt;
  const std::size_t begin = open + kOpen.size();
  const std::string_view name = std::string_view(*bytes).substr(begin, close - begin);
  return RosPackage{folder, std::string(read::trimmed(name))};
}

/// The package that the file belongs to.
inline std::optional<RosPackage> own_package(const Context& context) {
  constexpr int kMaxAncestors = 16;  // as the resolver looks
  std::string folder(context.folder());
  for (int i = 0; i < kMaxAncestors; ++i) {
    if (auto package = package_in(folder, context)) return package;
    const std::string above = normalize_path(folder + "/..");
    if (above == folder) break;
    folder = above;
  }
  return std::nullopt;
}

/// Where the package of a package:// URI lies that leads to no file in it; empty when the package is not found.
inline std::string package_without_file(std::string_view uri, const read::Resolution& found,
                                        const Context& context) {
  constexpr std::string_view kScheme = "package://";
  if (!uri.starts_with(kScheme)) return {};
  const std::string_view rest = uri.substr(kScheme.size());
  const std::size_t slash = rest.find('/');
  if (slash == std::string_view::npos) return {};
  const std::string inside = "/" + normalize_path(rest.substr(slash + 1));
  for (const read::Tried& tried : found.tried) {
    if (!tried.path.ends_with(inside)) continue;
    const std::string folder = tried.path.substr(0, tried.path.size() - inside.size());
    if (context.disk().kind(folder) != PathKind::kFolder) continue;
    const auto package = package_in(folder, context);
    if (package ? package->name == rest.substr(0, slash)
                : file_name(folder) == rest.substr(0, slash)) {
      return folder;
    }
  }
  return {};
}

}  // namespace rigor::rules
