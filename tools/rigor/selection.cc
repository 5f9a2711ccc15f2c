// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "selection.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "command.h"
#include "search.h"

namespace rigor::tool {
namespace {

Severity severity_named(const std::string& name) {
  constexpr Severity kAll[] = {Severity::kError, Severity::kWarning, Severity::kInfo};
  return kAll[choice("severity", name, {"error", "warning", "info"})];
}

/// How many severities fail: "error" is one, "warning" two, "info" three, "never" none.
std::size_t failing(const std::string& fail_on) {
  const std::size_t level =
      choice("--fail-on level", fail_on, {"error", "warning", "info", "never"});
  return level == 3 ? 0 : level + 1;
}

void list_option(CLI::App& app, const std::string& name, std::vector<std::string>& list,
                 const std::string& description) {
  app.add_option(name, list, description)
      ->type_name("RULE,...")
      ->delimiter(',')
      ->allow_extra_args(false);
}

}  // namespace

void SelectionOptions::declare(CLI::App& app) {
  app.add_option("--fail-on", fail_on_,
                 "Least severity that makes the exit code 1: "
                 "error (default), warning, info, never")
      ->type_name("LEVEL");
  list_option(app, "--select", select_, "Only these rules or categories");
  list_option(app, "--ignore", ignore_, "Not these rules or categories");
  app.add_option("--severity", severity_, "Give a rule another severity: error, warning, info")
      ->type_name("RULE=LEVEL")
      ->allow_extra_args(false);
}

rules::Selection SelectionOptions::selection() const {
  failing(fail_on_);
  rules::Selection selection;
  selection.select = select_;
  selection.ignore = ignore_;
  for (const std::string& text : severity_) {
    auto [rule, level] = split_assignment("--severity", text);
    selection.severity.emplace_back(std::move(rule), severity_named(level));
  }
  return selection;
}

bool SelectionOptions::fails(const Diagnostics& diagnostics) const {
  constexpr Severity kAll[] = {Severity::kError, Severity::kWarning, Severity::kInfo};
  return std::any_of(kAll, kAll + failing(fail_on_), [&](Severity severity) {
    return diagnostics.count(severity) > 0;
  });
}

void require_known(const rules::Selection& selection, const rules::Registry& registry) {
  const std::optional<std::string> unknown = unknown_name(selection, registry);
  if (!unknown) return;
  std::vector<std::string_view> known;
  for (const rules::Rule& rule : registry.rules()) {
    known.push_back(rule.name);
    const std::string_view category = to_string(rule.category);
    if (std::find(known.begin(), known.end(), category) == known.end()) known.push_back(category);
  }
  const std::string hint = did_you_mean(*unknown, known);
  throw UsageError("unknown rule \"" + *unknown + '"' +
                   (hint.empty() ? "; `rigor rules` lists them" : hint));
}

}  // namespace rigor::tool
