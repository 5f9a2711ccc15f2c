// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "option/rule_settings.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <rigor/rules/target.h>

namespace rigor::tool {
namespace {

std::string severity_word(const config::Level& level) {
  return level ? std::string(to_string(*level)) : "off";
}

std::vector<Said> said_in_config(const std::vector<config::Name>& names) {
  std::vector<Said> list;
  for (const config::Name& name : names) list.push_back({name.value, {}, name.place});
  return list;
}

std::vector<Said> said_by_option(const std::vector<std::string>& names, const std::string& option) {
  std::vector<Said> list;
  for (const std::string& name : names) list.push_back({name, option});
  return list;
}

std::vector<std::string> values_of(const std::vector<Said>& list) {
  std::vector<std::string> values;
  for (const Said& each : list) values.push_back(each.value);
  return values;
}

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Looks names up, and tells of those that are unknown.
class ConfigNames {
 public:
  ConfigNames(std::string kind, const std::vector<std::string_view>& known)
      : kind_(std::move(kind)), known_(known.begin(), known.end()) {}

  void check(const std::string& name, const config::Place& place,
             std::vector<config::Problem>& problems) const {
    if (holds(known_, name)) return;
    problems.push_back(
        {place.line, "unknown " + kind_ + " \"" + name + '"', name, known_, place.path});
  }

  void check(const std::vector<config::Name>& names, std::vector<config::Problem>& problems) const {
    for (const config::Name& name : names) check(name.value, name.place, problems);
  }

 private:
  std::string kind_;
  std::vector<std::string> known_;
};

}  // namespace

RuleSettings::RuleSettings(const SelectionOptions& options, const ConfigOptions& config,
                           const rules::Registry& registry)
    : options_(options), config_(config), registry_(registry), given_(options.selection()) {
  require_known(given_, registry);
}

std::vector<config::Problem> RuleSettings::unknown_names(const config::Config& config) const {
  if (config.files.empty()) return {};
  const ConfigNames rules_and_categories("rule", names_of_rules(registry_));
  std::vector<config::Problem> problems;
  const auto check = [&](const config::RuleChoice& choice) {
    if (choice.select) rules_and_categories.check(*choice.select, problems);
    rules_and_categories.check(choice.ignore, problems);
    for (const auto& [name, level] : choice.severity) {
      rules_and_categories.check(name, level.place, problems);
    }
  };
  check(config.rules);
  for (const config::PerFile& each : config.per_file) check(each.rules);
  if (config.targets) {
    ConfigNames("target", rules::target_names()).check(*config.targets, problems);
  }
  return problems;
}

const config::Config& RuleSettings::sound(const std::string& path) const {
  const config::Config& config = config_.unchecked(path);
  if (sound_.contains(&config)) return config;
  std::vector<config::Problem> problems = config.problems;
  for (config::Problem& problem : unknown_names(config)) problems.push_back(std::move(problem));
  config_.refuse(std::move(problems));
  sound_.insert(&config);
  return config;
}

SaidOfFile RuleSettings::said(const std::string& path) const {
  const config::Config& config = sound(path);
  const config::RuleChoice choice = rules_for(config, config_.absolute(path));
  SaidOfFile said;
  said.select = said_by_option(given_.select, "--select");
  if (said.select.empty() && choice.select) said.select = said_in_config(*choice.select);
  for (Said& each : said_in_config(choice.ignore)) {
    if (!holds(given_.select, each.value)) said.ignore.push_back(std::move(each));
  }
  for (Said& each : said_by_option(given_.ignore, "--ignore")) said.ignore.push_back(each);
  for (const auto& [rule, level] : choice.severity) {
    if (!level.value && holds(given_.select, rule)) continue;
    said.severity[rule] = {severity_word(level.value), {}, level.place};
  }
  for (const auto& [rule, severity] : given_.severity) {
    said.severity[rule] = {std::string(to_string(severity)), "--severity"};
  }
  for (const rules::Target target : given_.targets) {
    said.targets.push_back({std::string(to_string(target)), "--target"});
  }
  if (said.targets.empty() && config.targets) said.targets = said_in_config(*config.targets);
  if (!options_.fail_on().empty()) {
    said.fail_on = {options_.fail_on(), "--fail-on"};
  } else if (config.fail_on) {
    const config::Level& level = config.fail_on->value;
    said.fail_on = {level ? std::string(to_string(*level)) : "never", {}, config.fail_on->place};
  } else {
    said.fail_on = {"error"};
  }
  return said;
}

rules::Selection RuleSettings::selection(const std::string& path) const {
  const SaidOfFile said = this->said(path);
  rules::Selection selection;
  selection.select = values_of(said.select);
  selection.ignore = values_of(said.ignore);
  for (const auto& [rule, level] : said.severity) {
    if (level.value == "off") {
      selection.ignore.push_back(rule);
    } else {
      selection.severity.emplace_back(rule, *fail_on_level(level.value));
    }
  }
  for (const Said& target : said.targets) {
    if (const auto known = rules::target_named(target.value)) selection.targets.push_back(*known);
  }
  return selection;
}

rules::Selection RuleSettings::selection_of_command(const std::string& path) const {
  rules::Selection selection = this->selection(path);
  selection.select = given_.select;
  selection.targets = given_.targets;
  return selection;
}

std::optional<Severity> RuleSettings::fail_on(const std::string& path) const {
  return fail_on_level(said(path).fail_on.value);
}

bool RuleSettings::fails(const rules::ValidateResult& result) const {
  const std::vector<Diagnostic>& all = result.diagnostics.list();
  return std::any_of(result.files.begin(), result.files.end(), [&](const auto& file) {
    if (file.first_finding == file.end_finding) return false;
    const auto level = fail_on_level(said(file.path).fail_on.value);
    for (std::size_t i = file.first_finding; level && i < file.end_finding; ++i) {
      if (all[i].severity <= *level) return true;
    }
    return false;
  });
}

bool RuleSettings::fails(const std::string& path, Severity severity) const {
  const std::optional<Severity> level = fail_on(path);
  return level && severity <= *level;
}

bool RuleSettings::fails(const std::string& path, const Diagnostics& found) const {
  const std::optional<Severity> level = fail_on(path);
  const auto& all = found.list();
  return level && std::any_of(all.begin(), all.end(), [&](const Diagnostic& diagnostic) {
           return diagnostic.severity <= *level;
         });
}

}  // namespace rigor::tool
