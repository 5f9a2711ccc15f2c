// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/project/project_settings.h>

#include <rigor/author/format/configured_style.h>
#include <rigor/rules/target.h>

namespace rigor::lsp {
namespace {

std::vector<std::string> values_of(const std::vector<config::Name>& names) {
  std::vector<std::string> values;
  for (const config::Name& name : names) values.push_back(name.value);
  return values;
}

read::ConfiguredPaths paths_of(const config::Config& config) {
  read::ConfiguredPaths paths;
  paths.folders = values_of(config.resolve_paths);
  for (const auto& [name, folder] : config.resolve_packages)
    paths.packages.emplace(name, folder.value);
  return paths;
}

}  // namespace

ProjectSettings::ProjectSettings(const Disk& disk) : configs_(disk, "/", {}) {}

rules::Selection ProjectSettings::selection(const std::string& path) const {
  const config::Config& config = configs_.of(path);
  const config::RuleChoice choice = rules_for(config, configs_.absolute(path));
  rules::Selection selection;
  if (choice.select) selection.select = values_of(*choice.select);
  selection.ignore = values_of(choice.ignore);
  for (const auto& [rule, level] : choice.severity) {
    if (level.value) {
      selection.severity.emplace_back(rule, *level.value);
    } else {
      selection.ignore.push_back(rule);
    }
  }
  if (!config.targets) return selection;
  for (const config::Name& target : *config.targets) {
    if (const auto known = rules::target_named(target.value)) selection.targets.push_back(*known);
  }
  return selection;
}

std::optional<std::string> ProjectSettings::baseline(const std::string& path) const {
  const config::Config& config = configs_.of(path);
  if (!config.baseline) return std::nullopt;
  return config.baseline->value;
}

author::FormatStyle ProjectSettings::layout(const std::string& path) const {
  return author::configured_style(configs_.of(path).layout);
}

std::vector<read::TemplateArguments> ProjectSettings::arguments(const std::string& path) const {
  std::vector<read::TemplateArguments> sets;
  const std::string absolute = configs_.absolute(path);
  for (const config::TemplateArguments& each : configs_.of(path).templates) {
    if (each.file.value == absolute) sets.insert(sets.end(), each.sets.begin(), each.sets.end());
  }
  return sets;
}

const read::ConfiguredPaths* ProjectSettings::resolve_paths(std::string_view file) const {
  const config::Config& config = configs_.beside(file);
  if (config.resolve_paths.empty() && config.resolve_packages.empty()) return nullptr;
  return &resolve_paths_.find(&config, [&config] { return paths_of(config); });
}

std::vector<config::Problem> ProjectSettings::problems(const std::string& path) const {
  return configs_.of(path).problems;
}

}  // namespace rigor::lsp
