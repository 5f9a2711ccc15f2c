// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which files a command takes of those that its paths mean: `--no-gitignore`, `--force-exclude`.

#pragma once

#include <rigor/read/discover.h>
#include <CLI/CLI.hpp>

namespace rigor::tool {

class FileOptions {
 public:
  void declare(CLI::App& app);

  /// With the working folder; what a configuration excludes is for the command to add.
  read::DiscoverOptions discover() const;

 private:
  bool no_gitignore_ = false;
  bool force_exclude_ = false;
};

}  // namespace rigor::tool
