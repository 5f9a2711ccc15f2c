// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where URIs are searched: `--model-path`, `--package`, the configuration, and the environment's
// variables; and the arguments of templates, `name:=value`.

#pragma once

#include <string>
#include <vector>

#include <rigor/read/resolver.h>
#include <CLI/CLI.hpp>

#include "project/config_file.h"

namespace rigor::tool {

/// The option that words `name:=value` of a command line are taken for.
inline constexpr const char* kTemplateArgumentOption = "--xacro-arg";

class SearchOptions {
 public:
  void declare(CLI::App& app);

  /// They look into the configuration as long as this lives.
  read::SearchPaths paths() const;

  const ConfigOptions& config() const { return config_; }

 private:
  std::vector<std::string> model_paths_;
  std::vector<std::string> packages_;
  std::vector<std::string> template_arguments_;
  ConfigOptions config_;
};

/// NAME and VALUE of an option's "NAME=VALUE"; a UsageError when there is no `=` or no name.
std::pair<std::string, std::string> split_assignment(const std::string& option,
                                                     const std::string& text);

}  // namespace rigor::tool
