// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Finds the file that a URI names, and remembers every place it looked.
//
// `model://NAME/rest`, `package://NAME/rest`, `file://path`, a relative path: searched through, in
// this order, the command line's `--model-path` and `--package`, the configuration's paths, the
// file's own model folder and its neighbors, the nearest ancestor's `package.xml` (with the folders
// of models that it tells Gazebo of, and `models` between it and the file), packages of the file's
// repository and workspace, the environment variables of Gazebo and ROS, `~/.gazebo/models`, and the
// Fuel cache. Nothing is ever downloaded.
//
//   Resolver resolver(disk, search_paths_from(environment));
//   Resolution found = resolver.resolve("model://arm/meshes/a.stl", "worlds/lab.sdf");
//   if (!found.path) for (const Tried& place : found.tried) say(place.path, place.origin);

#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/read/package_manifest.h>
#include <rigor/text/disk.h>
#include <rigor/text/other_case.h>

namespace rigor::read {

class PackageIndex;

/// A folder to search in, and who named it: "--model-path", "GZ_SIM_RESOURCE_PATH".
struct SearchPath {
  std::string folder;
  std::string origin;
};

/// What a project's configuration says of paths.
struct ConfiguredPaths {
  std::vector<std::string> folders;
  std::map<std::string, std::string> packages;  ///< folders, by package
};

/// `name:=value`, in their order.
using TemplateArguments = std::vector<std::pair<std::string, std::string>>;

/// What templates are given besides their files.
struct TemplateInputs {
  TemplateArguments arguments;
  /// A variable of the environment, for templates that name it; no function, no variables.
  std::function<std::optional<std::string>(std::string_view name)> variable;
  std::string working_folder;  ///< absolute; where relative paths begin
};

struct SearchPaths {
  std::vector<SearchPath> given;                ///< from the command line
  std::map<std::string, std::string> packages;  ///< `--package NAME=DIR`
  std::vector<SearchPath> environment;          ///< of models and packages, in the contract's order
  std::string fuel_cache;                       ///< empty when there is none
  /// Of the configuration for what stands in a file; null, or no function, when there is none. Safe across
  /// threads; what it gives is valid as long as the resolver.
  std::function<const ConfiguredPaths*(std::string_view file)> configured;
  TemplateInputs templates;
  std::vector<std::string> named;  ///< folders that a command was given: packages in them are found
};

/// The paths that the environment's variables name; `variable` gives a variable's value, empty when
/// it is not set, as a wrapper of getenv does.
SearchPaths search_paths_from(const std::function<std::string(const std::string&)>& variable);

struct Tried {
  std::string path;
  std::string origin;  ///< who named the folder
};

struct Resolution {
  std::optional<std::string> path;  ///< of the file or folder; nothing when it is not found
  std::vector<Tried> tried;         ///< in order; the last is the hit, when there is one
  bool remote = false;              ///< http(s): never fetched, and not in the cache
  std::string scheme;               ///< "model", "package", "file", "https"; empty for a path
  /// Set when nothing is found but a path that differs only in letter case exists.
  std::string other_case;
};

class Resolver {
 public:
  Resolver(const Disk& disk, SearchPaths paths);

  /// Where `uri`, standing in `file`, leads.
  Resolution resolve(std::string_view uri, std::string_view file) const;

  /// The folder of a ROS package, as `$(find NAME)` in `file` has it, which is absolute. In this order:
  /// `--package`; the configuration; the nearest package.xml; packages around the file (`trees_around`) and
  /// in the folders that a command was given; ROS_PACKAGE_PATH, with all that is below; AMENT_PREFIX_PATH.
  std::optional<std::string> package_folder(std::string_view name, std::string_view file) const;

  const Disk& disk() const { return disk_; }
  const SearchPaths& paths() const { return paths_; }

 private:
  const ConfiguredPaths* configured(std::string_view file) const;
  /// Each says whether it was found; what was tried is remembered.
  bool try_path(std::string path, std::string_view origin, Resolution& result) const;
  bool try_folders(const std::vector<SearchPath>& folders, std::string_view rest,
                   Resolution& result) const;
  bool try_configured(const ConfiguredPaths& paths, std::string_view rest,
                      Resolution& result) const;
  void resolve_model(std::string_view rest, std::string_view file, Resolution& result) const;
  void resolve_package(std::string_view rest, std::string_view file, Resolution& result) const;
  bool try_package_above(const std::string& name, std::string_view inside, std::string_view file,
                         Resolution& result) const;
  bool try_package_around(const std::string& name, std::string_view inside, std::string_view file,
                          Resolution& result) const;
  bool try_below_environment(const std::string& name, std::string_view inside,
                             std::string_view file, Resolution& result) const;
  void resolve_remote(std::string_view uri, Resolution& result) const;
  void find_other_case(Resolution& result) const;
  const std::optional<PackageManifest>& manifest(const std::string& folder) const;
  /// Where the package that a folder belongs to keeps models: `models` in the folder or above it, and
  /// what the package tells Gazebo of. Nothing for a folder of no package.
  const std::vector<std::string>& package_folders(const std::string& folder) const;
  std::vector<std::string> find_package_folders(const std::string& folder) const;

  /// Looked for once, by folder: a file may name hundreds of models that are nowhere.
  struct Packages {
    std::mutex mutex;
    std::map<std::string, std::optional<PackageManifest>> manifests;
    std::map<std::string, std::vector<std::string>> folders;
  };

  const Disk& disk_;
  SearchPaths paths_;
  std::shared_ptr<Packages> packages_ = std::make_shared<Packages>();
  std::shared_ptr<PackageIndex> index_;
  std::shared_ptr<OtherCase> other_case_;
};

}  // namespace rigor::read
