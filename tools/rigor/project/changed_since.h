// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `--changed-since REV`: of the files that were found, only those to which something happened since.
//
//   std::optional<ChangedFiles> changed = changed_since_.changed(paths);  // asks git
//   if (changed) options.discover.wanted = [&](const std::string& path) {
//     return changed->concern(disk, resolver, path);
//   };
//
// A file is concerned when its own bytes differ from those of REV or git does not know it, or when that is
// so of a file that it names: a mesh, a model that it includes, those that are gone among them. What such
// a file names in turn is its own concern. Of a submodule all files are, once it differs.

#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/read/resolver.h>
#include <rigor/text/disk.h>
#include <CLI/CLI.hpp>

namespace rigor::tool {

class ChangedFiles {
 public:
  /// `paths` are absolute; one that is a folder represents all that is in it.
  ChangedFiles(std::string revision, std::set<std::string> paths);

  bool concern(const Disk& disk, const read::Resolver& resolver, const std::string& path);

  /// "nothing changed since HEAD~1: 12 files are as they were", when no file was concerned.
  std::optional<std::string> nothing() const;

 private:
  bool has(const std::string& path) const;
  bool names_one(const Disk& disk, const read::Resolver& resolver, const std::string& path) const;
  bool leads_to_one(const read::Resolver& resolver, std::string_view uri,
                    const std::string& path) const;

  std::string revision_;
  std::set<std::string> paths_;
  std::set<std::string> folders_;  ///< that they are in
  std::size_t concerned_ = 0;
  std::size_t others_ = 0;
};

class ChangedSinceOption {
 public:
  void declare(CLI::App& app);

  /// What git says of the repositories that these files and folders are in; nothing without the option. A
  /// UsageError with git's own words when one is in none, or there is no such revision in it.
  std::optional<ChangedFiles> changed(const std::vector<std::string>& paths) const;

 private:
  std::string revision_;
};

}  // namespace rigor::tool
