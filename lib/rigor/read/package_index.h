// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where ROS packages lie in source trees that nobody has installed: every `package.xml` below a folder,
// by the name that it gives. A tree is listed when the first name is asked for, and once.
//
//   PackageIndex index(disk, {"/ws/src"});
//   index.find_around("lidar_description", "/ws/src/robots/arm/urdf");  // "/ws/src/sensors/lidar_description"

#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/text/disk.h>

namespace rigor::read {

/// The tree that a folder belongs to: its repository, else the folder in which packages lie side by side,
/// else the folder itself.
std::string tree_of(const Disk& disk, const std::string& folder);

/// Where packages that a file in the folder may name are looked for, nearest first: the folder's tree; of a
/// submodule also the repository around it; workspaces, which are a folder `src` above that is in no package,
/// or one beside `build`, `install` or `devel`.
std::vector<std::string> trees_around(const Disk& disk, const std::string& folder);

class PackageIndex {
 public:
  /// `named` are folders that a user named, which are searched behind those around a file.
  PackageIndex(const Disk& disk, std::vector<std::string> named);

  /// The folder of the package, for a file in `folder`. Of several with one name, the one that shares the
  /// most folders with it, then the first by path. Safe across threads, as are all.
  std::optional<std::string> find_around(std::string_view name, const std::string& folder);
  std::optional<std::string> find_below(std::string_view name, const std::string& root,
                                        const std::string& folder);

  /// What `find_around` searches.
  std::vector<std::string> searched(const std::string& folder);

 private:
  using Folders = std::map<std::string, std::vector<std::string>, std::less<>>;  // by package
  const Folders& packages_below(const std::string& root);
  void gather(const std::string& folder, int depth, Folders& into);
  std::optional<std::string> find(std::string_view name, const std::string& root,
                                  const std::string& folder);
  const std::vector<std::string>& roots_around(const std::string& folder);

  std::mutex mutex_;
  const Disk& disk_;
  std::vector<std::string> named_;
  std::map<std::string, Folders> by_root_;
  std::map<std::string, std::vector<std::string>> roots_;  // by folder
  int listed_ = 0;
};

}  // namespace rigor::read
