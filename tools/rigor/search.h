// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where URIs are searched: `--model-path`, `--package`, and the environment's variables.

#pragma once

#include <string>
#include <vector>

#include <rigor/read/resolver.h>
#include <CLI/CLI.hpp>

namespace rigor::tool {

class SearchOptions {
 public:
  void declare(CLI::App& app);

  read::SearchPaths paths() const;

 private:
  std::vector<std::string> model_paths_;
  std::vector<std::string> packages_;
};

/// NAME and VALUE of an option's "NAME=VALUE"; a UsageError when there is no `=` or no name.
std::pair<std::string, std::string> split_assignment(const std::string& option,
                                                     const std::string& text);

}  // namespace rigor::tool
