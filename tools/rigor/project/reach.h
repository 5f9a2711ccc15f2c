// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How far an untrusted model may lead rigor. What CI publishes must hold no file of the machine that ran it:
// an include of "../../.ssh/id" is named in a report, and none of its bytes is in it.
//
//   const Reach reach({"robots/arm"}, search_paths);
//   reach.holds("robots/arm/meshes/link.stl");   // true
//   reach.holds("/proc/self/environ");           // false

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <rigor/read/resolver.h>
#include <rigor/text/diagnostic.h>
#include <rigor/text/sources.h>

namespace rigor::tool {

/// The folders that were named on the command line, of a named file the one that it is in, and the packages (a
/// folder with package.xml or model.config) that these lie in; packages beside those, and where `$(find …)` looks
/// for packages around them (`read::trees_around`); models anywhere in their repository; and the folders of
/// `--model-path`, `--package` and the environment's variables. Not those that a configuration names: it comes with the models.
/// Links are followed first, and nothing in a folder `.git` is within reach. Safe across threads.
class Reach {
 public:
  /// Everything.
  Reach() = default;
  Reach(const std::vector<std::string>& named, const read::SearchPaths& paths);

  bool holds(const std::string& path) const;

 private:
  bool everything_ = true;
  std::vector<std::string> named_;      // files, as they were written
  std::vector<std::string> folders_;    // real paths
  std::vector<std::string> neighbors_;  // folders whose packages are within reach
  struct Tree {
    std::string folder;
    bool is_repository = false;
  };
  bool holds_in(const Tree& tree, const std::string& real) const;
  void add_trees(const std::string& real_folder);

  std::vector<Tree> trees_;  // packages at any depth of them are
};

/// The path with all links followed, as far as it exists; from the root.
std::string real_path_of(const std::string& path);

/// Whether a real path is the folder, or lies below it.
bool lies_below(std::string_view path, std::string_view folder);

/// The findings without a word of files that are out of reach: such a finding names its rule, the file and the
/// line, and neither quotes nor mends it. How a mesh is shaped is told wherever it lies.
Diagnostics withheld(const Diagnostics& found, const Sources& sources, const Reach& reach);

}  // namespace rigor::tool
