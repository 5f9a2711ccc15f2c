// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What of the findings a terminal lists: `--show LEVEL` and `--summary`. Other formats are complete.

#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <rigor/rules/validate.h>
#include "option/rule_settings.h"
#include "option/validation_format.h"
#include "output/output.h"

namespace rigor::tool {

class ShowOptions {
 public:
  void declare(CLI::App& app);

  /// A UsageError for a level that is none, and for `--summary` where no target is for people.
  void check(const std::vector<Target>& targets) const;

  /// As `--show` says; warning when it is not given.
  Severity least() const;

  /// Errors and warnings, and whatever fails the run: with `--fail-on info` infos too.
  TerminalView view(const rules::ValidateResult& result, const RuleSettings& settings) const;

 private:
  std::string min_;
  bool summary_ = false;
};

}  // namespace rigor::tool
