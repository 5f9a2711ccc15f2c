// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "option/show_options.h"

#include <algorithm>
#include <string_view>

#include "command/command.h"

namespace rigor::tool {
namespace {

constexpr std::string_view kShowLevels[] = {"error", "warning", "info"};

Severity show_level(const std::string& name) {
  constexpr Severity kLevels[] = {Severity::kError, Severity::kWarning, Severity::kInfo};
  return kLevels[choice("--show level", name, kShowLevels)];
}

}  // namespace

void ShowOptions::declare(CLI::App& app) {
  offer(app.add_option("--show", min_,
                       "Lowest severity that is listed: error, warning (the default) or info")
            ->type_name("LEVEL"),
        kShowLevels);
  app.add_flag("--summary", summary_, "A table of rules instead of a list of findings");
}

void ShowOptions::check(const std::vector<Target>& targets) const {
  if (!min_.empty()) show_level(min_);
  if (summary_ && std::none_of(targets.begin(), targets.end(),
                               [](const Target& target) { return target.format == 0; })) {
    throw UsageError("--summary is of the format pretty: the other formats list all findings");
  }
}

Severity ShowOptions::least() const { return min_.empty() ? Severity::kWarning : show_level(min_); }

TerminalView ShowOptions::view(const rules::ValidateResult& result,
                               const RuleSettings& settings) const {
  TerminalView view;
  if (summary_) view.form = TerminalView::Form::kTable;
  view.least = least();
  if (!min_.empty()) return view;
  if (summary_ || std::any_of(result.files.begin(), result.files.end(),
                              [&settings](const rules::FileSummary& file) {
                                return settings.fail_on(file.path) == Severity::kInfo;
                              })) {
    view.least = Severity::kInfo;
  }
  return view;
}

}  // namespace rigor::tool
