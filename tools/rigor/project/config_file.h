// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The project's configuration for what a command looks at: the nearest `rigor.toml`, or what `--config`
// and `--isolated` say.
//
//   const config::Config& config = config_.of("my_robot/model.sdf");

#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/config/configs.h>
#include <rigor/read/resolver.h>
#include <rigor/text/disk.h>
#include <rigor/text/found_once.h>
#include <CLI/CLI.hpp>

#include "project/guarded_disk.h"

namespace rigor::tool {

class ConfigOptions {
 public:
  void declare(CLI::App& app);

  /// Before any thread asks for something. A UsageError when what `--config` names cannot be used.
  void open() const;

  /// Forgets what was read: from now on configurations are as they are on this disk, which outlives this
  /// or the next call. For one who checks again; not while a thread asks for something.
  void reopen(const Disk& disk) const;

  /// Of a file or folder. A UsageError that tells of all that cannot stand in it.
  const config::Config& of(const std::string& path) const;

  /// The same, its problems left to the caller.
  const config::Config& unchecked(const std::string& path) const { return configs().of(path); }

  /// kg/m³, by name.
  std::map<std::string, double> materials(const std::string& path) const;

  /// Where URIs that stand in the file are searched; null when no configuration says it. Safe across
  /// threads.
  const read::ConfiguredPaths* resolve_paths(std::string_view file) const;

  /// The pattern of `exclude` and its place; empty when the file or folder is not excluded.
  std::string why_excluded(const std::string& path, PathKind kind) const;

  /// The one that the configurations of all these name; a UsageError when they name several.
  std::optional<std::string> baseline(const std::vector<std::string>& paths) const;

  /// The folders that `--confine` names, links followed: nothing outside of them is read. Empty without it. A
  /// UsageError when one is not there.
  std::vector<std::string> confinement() const;

  bool is_isolated() const { return isolated_; }

  /// The disk that configurations are read from.
  const Disk& disk() const;

  /// As configurations have paths.
  std::string absolute(const std::string& path) const { return configs().absolute(path); }

  /// A path of a configuration as a user in this folder writes it.
  std::string shown(const std::string& path) const;

  /// "../rigor.toml:4"
  std::string shown(const config::Place& place) const;

  /// Tells of each on stderr, by file and line, and throws a UsageError, when there is any.
  void refuse(std::vector<config::Problem> problems) const;

 private:
  const config::Configs& configs() const { return opened().configs; }
  bool quotable(const std::string& path) const;
  std::string told(const config::Problem& problem) const;
  const config::Config& sound(const config::Config& config) const;

  std::string file_;
  bool isolated_ = false;
  /// What was read so far.
  struct Opened {
    Opened(const Disk& disk, std::string working_folder, config::ConfigChoice choice)
        : configs(disk, std::move(working_folder), std::move(choice)) {}

    config::Configs configs;
    FoundOnce<const config::Config*, read::ConfiguredPaths> resolve_paths;
  };
  Opened& opened() const;

  std::vector<std::string> confine_;
  mutable std::unique_ptr<const GuardedDisk> own_disk_;  // within the confinement
  mutable const Disk* disk_ = nullptr;
  mutable std::unique_ptr<Opened> opened_;
};

}  // namespace rigor::tool
