// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is missing behind a URI that leads to no file: a package is one cause, however many of its files are
// named.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <rigor/read/resolver.h>
#include <rigor/rules/context.h>
#include <rigor/text/disk.h>
#include <rigor/text/path.h>

namespace rigor::rules {

/// The path, or the outermost of the folders around it that does not exist.
inline std::string outermost_missing(std::string_view path, const Context& context) {
  std::string missing = normalize_path(path);
  for (std::string above(parent_path(missing)); above != missing; above = parent_path(above)) {
    if (context.disk().kind(above) != PathKind::kMissing) break;
    missing = above;
  }
  return missing;
}

/// "package://arm_description" or "model://arm" where that folder does not exist, else the file, or the folder
/// around it that does not exist, at the first place where it was looked for.
inline std::string missing_part(std::string_view uri, const read::Resolution& found,
                                const Context& context) {
  if (found.tried.empty()) return std::string(uri);
  const bool names_folder = uri.starts_with("package://") || uri.starts_with("model://");
  if (!names_folder) return outermost_missing(found.tried.front().path, context);
  const std::size_t slash = uri.find('/', uri.find("://") + 3);
  const std::string_view folder_uri = uri.substr(0, slash);
  const std::string inside = slash == uri.npos ? "" : "/" + normalize_path(uri.substr(slash + 1));
  for (const read::Tried& tried : found.tried) {
    if (inside.empty() || !tried.path.ends_with(inside)) continue;
    const std::string folder = tried.path.substr(0, tried.path.size() - inside.size());
    if (context.disk().kind(folder) == PathKind::kFolder)
      return outermost_missing(tried.path, context);
  }
  return std::string(folder_uri);
}

}  // namespace rigor::rules
