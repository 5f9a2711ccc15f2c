// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which files may refer to a model by name: those of the repository or package that it is in.
//
//   const std::string folder = workspace_folder(disk, "urdf/robot.urdf");
//   const WorkspaceFiles files = workspace_files(disk, {folder}, "/home/me/robot");
//   const auto some = files.that_may_hold({"wheel"}, disk);
//
// What git ignores is left out, as are hidden folders and those with COLCON_IGNORE.

#pragma once

#include <initializer_list>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/text/disk.h>

namespace rigor::author {

/// The root of the repository that the file is in; outside of one the nearest folder above it with a package.xml or a
/// rigor.toml, else its own folder. Relative as the file is.
std::string workspace_folder(const Disk& disk, const std::string& file);

struct WorkspaceFiles {
  /// SDF, worlds, URDF, templates and SRDF: their names are known (name_graph.h).
  std::vector<std::string> models;
  /// YAML and TOML (parameter_names.h), and texts in which a name is only a word (text_mentions.h).
  std::vector<std::string> texts;
  /// Whether all folders were walked: a bound ends that of a home folder that is a repository.
  bool is_complete = true;

  /// Those whose bytes hold the first word of a name. Of templates, which compose names, all up to a bound.
  std::vector<std::string> that_may_hold(const std::set<std::string>& names,
                                         const Disk& disk) const;
};

/// Of folders and below them, sorted, each once. Relative paths begin in `working_folder`; empty: the paths are
/// absolute.
WorkspaceFiles workspace_files(const Disk& disk, const std::vector<std::string>& folders,
                               const std::string& working_folder);

/// Files beside a model that may hold its names. What a person named is taken at its word: a name in YAML that was
/// named is the model's, whatever other models of the workspace have that name, too.
struct ReferringFiles {
  std::vector<std::string> named;
  std::vector<std::string> found = {};

  ReferringFiles() = default;
  ReferringFiles(std::initializer_list<std::string> the_named) : named(the_named) {}
  ReferringFiles(std::vector<std::string> the_named, std::vector<std::string> the_found = {});
  /// Named ones first; each once.
  std::vector<std::string> all() const;
};

}  // namespace rigor::author
