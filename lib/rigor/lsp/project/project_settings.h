// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the nearest `rigor.toml` says of a file, as the library takes it: rules, search paths, arguments of
// templates, layout.
//
//   ProjectSettings settings(disk);
//   options.selection_for = [&](const std::string& path) { return settings.selection(path); };
//
// A configuration with problems is used as far as it can be read, since whoever types in it has more to say.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/author/format/format_style.h>
#include <rigor/config/configs.h>
#include <rigor/read/resolver.h>
#include <rigor/rules/validate.h>
#include <rigor/text/disk.h>
#include <rigor/text/found_once.h>

namespace rigor::lsp {

class ProjectSettings {
 public:
  /// The disk outlives it. What was read is kept: make another one when a configuration changes.
  explicit ProjectSettings(const Disk& disk);

  rules::Selection selection(const std::string& path) const;
  /// The path of the file that counts known findings.
  std::optional<std::string> baseline(const std::string& path) const;
  author::FormatStyle layout(const std::string& path) const;
  /// Sets of arguments of the template at a path.
  std::vector<read::TemplateArguments> arguments(const std::string& path) const;
  /// Null where nothing is configured. Safe across threads.
  const read::ConfiguredPaths* resolve_paths(std::string_view file) const;
  /// What stands in a configuration and cannot.
  std::vector<config::Problem> problems(const std::string& path) const;

 private:
  config::Configs configs_;
  mutable FoundOnce<const config::Config*, read::ConfiguredPaths> resolve_paths_;
};

}  // namespace rigor::lsp
