// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A list of patterns in a configuration, for paths below its folder, as a .gitignore there would have
// them.
//
//   PathPatterns worlds("/home/me/robot", {{"worlds/**", place}, {"!worlds/lab.sdf", place}});
//   worlds.covers("/home/me/robot/worlds/yard.sdf", PathKind::kFile);

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <rigor/config/setting.h>
#include <rigor/text/disk.h>
#include <rigor/text/gitignore.h>

namespace rigor::config {

class PathPatterns {
 public:
  PathPatterns() = default;
  PathPatterns(std::string folder, std::vector<Name> patterns);

  /// Whether the last pattern that names the path, or a folder that it is in, is one without `!`. What is
  /// not below the folder is not covered. Both are absolute, or both relative to one place.
  bool covers(std::string_view path, PathKind kind) const {
    return covering(path, kind) != nullptr;
  }

  /// That pattern; null when the path is not covered.
  const Name* covering(std::string_view path, PathKind kind) const;

  const std::string& folder() const { return folder_; }
  const std::vector<Name>& written() const { return written_; }

 private:
  const Name* naming(std::string_view path, PathKind kind) const;

  std::string folder_;
  std::vector<Name> written_;
  std::vector<IgnorePattern> patterns_;
};

/// Why it cannot stand in such a list; empty when it can.
std::string unusable_pattern(std::string_view pattern);

}  // namespace rigor::config
