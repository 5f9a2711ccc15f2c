// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where URIs are searched: `--model-path`, `--package`, the configuration, and the environment's
// variables; and the arguments of templates, `name:=value`.

#pragma once

#include <string>
#include <vector>

#include <rigor/process/workers.h>
#include <rigor/read/resolver.h>
#include <CLI/CLI.hpp>

#include "project/config_file.h"

namespace rigor::tool {

/// The option that words `name:=value` of a command line are taken for.
inline constexpr const char* kTemplateArgumentOption = "--xacro-arg";

class SearchOptions {
 public:
  void declare(CLI::App& app);

  /// They look into the configuration as long as this lives. Of `named`, what the command was given, the
  /// folders are searched for packages.
  read::SearchPaths paths(const std::vector<std::string>& named = {}) const;

  /// For a command that takes several files: those arguments of templates that stand behind a file and before
  /// the next. Those that stand before all files count for each.
  read::TemplateArguments arguments_of(const CLI::Option& file,
                                       const std::vector<const CLI::Option*>& files) const;

  const ConfigOptions& config() const { return config_; }

  /// As much memory for imports as was asked for.
  void allow(process::Workers& workers) const;

  /// For what a command is asked to do with these paths: within `--confine`, and with their reach. A UsageError
  /// when the configuration of one cannot be used.
  GuardedDisk disk(const std::vector<std::string>& named) const;
  /// The same for one who refuses these configurations with `RuleSettings`, which knows the names of rules, too.
  GuardedDisk unchecked_disk(const std::vector<std::string>& named) const;

 private:
  std::vector<std::string> model_paths_;
  std::vector<std::string> packages_;
  std::vector<std::string> template_arguments_;
  const CLI::App* app_ = nullptr;
  const CLI::Option* argument_option_ = nullptr;
  std::string mesh_memory_;
  ConfigOptions config_;
};

/// The value of a variable of the environment; empty when it is not set.
std::string path_variable(const std::string& name);

/// NAME and VALUE of an option's "NAME=VALUE"; a UsageError when there is no `=` or no name.
std::pair<std::string, std::string> split_assignment(const std::string& option,
                                                     const std::string& text);

}  // namespace rigor::tool
