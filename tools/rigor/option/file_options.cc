// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "option/file_options.h"

#include <filesystem>
#include <system_error>

namespace rigor::tool {

void FileOptions::declare(CLI::App& app) {
  app.add_flag("--no-gitignore", no_gitignore_, "Include files that git ignores");
  app.add_flag("--force-exclude", force_exclude_,
               "Skip ignored or excluded files even when they are named");
}

read::DiscoverOptions FileOptions::discover() const {
  read::DiscoverOptions options;
  using read::GitIgnoring, read::NamedPaths;
  options.git_ignoring = no_gitignore_ ? GitIgnoring::kPassOver : GitIgnoring::kHonor;
  options.named = force_exclude_ ? NamedPaths::kJudge : NamedPaths::kAlwaysTake;
  std::error_code error;
  options.working_folder = std::filesystem::current_path(error).string();
  return options;
}

}  // namespace rigor::tool
