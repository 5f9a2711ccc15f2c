// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "option/selection.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <rigor/rules/registry.h>
#include <rigor/rules/target.h>

#include "command/command.h"
#include "option/search.h"

namespace rigor::tool {
namespace {

constexpr std::string_view kFailOnLevels[] = {"error", "warning", "info", "never"};

Severity severity_named(const std::string& name) {
  constexpr Severity kAll[] = {Severity::kError, Severity::kWarning, Severity::kInfo};
  return kAll[choice("severity", name, Names(kFailOnLevels).first(3))];
}

CLI::Option* list_option(CLI::App& app, const std::string& name, std::vector<std::string>& list,
                         const std::string& type, const std::string& description) {
  return app.add_option(name, list, description)
      ->type_name(type)
      ->delimiter(',')
      ->allow_extra_args(false);
}

}  // namespace

void SelectionOptions::declare(CLI::App& app) {
  offer(app.add_option("--fail-on", fail_on_,
                       "Lowest severity that makes the exit code 1: "
                       "error (default), warning, info, never")
            ->type_name("LEVEL"),
        kFailOnLevels);
  list_option(app, "--select", select_, "RULE,...", "Only these rules or categories");
  list_option(app, "--ignore", ignore_, "RULE,...", "Skip these rules or categories");
  app.add_option("--severity", severity_,
                 "Change the severity of a rule or category: error, warning, info")
      ->type_name("RULE=LEVEL")
      ->allow_extra_args(false);
  offer(list_option(app, "--target", targets_, "NAME,...",
                    "Run the rules for these consumers as well: " + listed(rules::target_names())),
        rules::target_names());
}

rules::Selection SelectionOptions::selection() const {
  if (!fail_on_.empty()) fail_on_level(fail_on_);
  rules::Selection selection;
  selection.select = select_;
  selection.ignore = ignore_;
  for (const std::string& text : severity_) {
    auto [rule, level] = split_assignment("--severity", text);
    selection.severity.emplace_back(std::move(rule), severity_named(level));
  }
  for (const std::string& name : targets_) {
    const std::size_t index = choice("target", name, rules::target_names());
    selection.targets.push_back(*rules::target_named(rules::target_names()[index]));
  }
  return selection;
}

std::optional<Severity> fail_on_level(const std::string& name) {
  constexpr std::optional<Severity> kLevels[] = {Severity::kError, Severity::kWarning,
                                                 Severity::kInfo, std::nullopt};
  return kLevels[choice("--fail-on level", name, kFailOnLevels)];
}

std::vector<std::string_view> names_of_rules(const rules::Registry& registry) {
  std::vector<std::string_view> known;
  std::set<rules::Category> categories;
  for (const rules::Rule& rule : registry.rules()) {
    known.push_back(rule.name);
    if (categories.insert(rule.category).second) known.push_back(to_string(rule.category));
  }
  for (const std::string_view former : rules::former_names()) known.push_back(former);
  return known;
}

void require_known(const rules::Selection& selection, const rules::Registry& registry) {
  const std::optional<std::string> unknown = unknown_name(selection, registry);
  if (!unknown) return;
  const std::string hint = did_you_mean(*unknown, names_of_rules(registry));
  throw UsageError("unknown rule \"" + *unknown + '"' +
                   (hint.empty() ? "; `rigor rules` lists them" : hint));
}

}  // namespace rigor::tool
