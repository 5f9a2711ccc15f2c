// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where a ROS package lies, for `$(find NAME)` in a source tree that nobody has installed.
//
// In this order: `--package NAME=DIR`; the nearest package.xml above the file; packages of the same
// repository, which is the folder above the file that has a `.git`, else the highest one in which
// packages lie side by side; AMENT_PREFIX_PATH; ROS_PACKAGE_PATH.

#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/read/resolver.h>
#include <rigor/text/disk.h>

namespace rigor::read {

class PackageFinder {
 public:
  PackageFinder(const Disk& disk, SearchPaths paths);

  /// The tree that a folder belongs to: its repository, else the folder in which packages lie side by side,
  /// else the folder itself.
  std::string tree_of(const std::string& folder) const { return workspace_of(folder); }

  /// The folder that holds the package's files; nothing where it is not found. `file` is absolute. Safe
  /// across threads.
  std::optional<std::string> find(std::string_view name, std::string_view file);

 private:
  using Folders = std::map<std::string, std::string, std::less<>>;  // by package
  const Folders& packages_near(const std::string& folder);
  void gather(const std::string& folder, int depth, Folders& into);
  std::string workspace_of(const std::string& folder) const;

  std::optional<std::string> search(std::string_view name, const std::string& file);

  std::mutex mutex_;
  const Disk& disk_;
  SearchPaths paths_;
  std::map<std::string, Folders> by_workspace_;
  std::map<std::string, std::string> workspaces_;  // by folder of a file
  int looked_at_ = 0;
};

}  // namespace rigor::read
