// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which files a list of paths means: a file is itself, a folder is what it holds of models.
//
//   Discovered found = discover(disk, {"my_robot", "worlds/lab.world"});
//
// What a repository ignores is passed over in a folder, and so are hidden folders (`.git`) and those that
// hold a file COLCON_IGNORE, as the build, install and log folders of a colcon workspace do. What is named
// is examined all the same, unless `named` says that it is to be judged like the rest.

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <rigor/text/disk.h>

namespace rigor::read {

/// Whether `.gitignore` files are read (see repository_ignores.h).
enum class GitIgnoring : std::uint8_t { kHonor, kPassOver };

/// What becomes of a path that is named itself and that is ignored or excluded. A hook of pre-commit names
/// every file that changed, so it asks for kJudge.
enum class NamedPaths : std::uint8_t { kAlwaysTake, kJudge };

struct DiscoverOptions {
  GitIgnoring git_ignoring = GitIgnoring::kHonor;
  NamedPaths named = NamedPaths::kAlwaysTake;
  /// Why a file or folder is excluded, "exclude = \"vendor/\" in rigor.toml line 3"; empty when it is not.
  /// Asked with the path as it would be reported. A folder above it may be why as well.
  std::function<std::string(const std::string& path, PathKind kind)> excluded;
  /// Whether a file that was found is to be taken, as one that changed; all are when empty. Called once a
  /// file, in their order.
  std::function<bool(const std::string& path)> wanted;
  /// Where relative paths begin, as an absolute path. Without it nobody knows what lies above them.
  std::string working_folder;
};

struct LeftOut {
  std::string path;
  std::string why;
  bool excluded = false;  ///< ignored, excluded, or what cannot be listed or read; else a template
};

struct Discovered {
  std::vector<std::string> files;  ///< each once, in the order of the arguments, then by name
  /// Templates, which somebody has to expand; named and excluded; folders that cannot be listed, and
  /// `.gitignore` files that cannot be read.
  std::vector<LeftOut> left_out;
  std::vector<std::string> unusable;  ///< arguments that do not exist, and folders without a model
  std::vector<std::string>
      semantic;  ///< SRDF in folders: no models, but they name links and joints
};

/// Folders are walked without following links to other folders.
Discovered discover(const Disk& disk, const std::vector<std::string>& paths,
                    const DiscoverOptions& options);
Discovered discover(const Disk& disk, const std::vector<std::string>& paths);

}  // namespace rigor::read
