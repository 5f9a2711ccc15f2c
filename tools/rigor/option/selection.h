// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which rules run, how severe they are, and which findings make the exit code 1: `--select`,
// `--ignore`, `--severity`, `--target`, `--fail-on`. What a configuration says of that as well is
// `RuleSettings`' to join.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include <rigor/rules/registry.h>
#include <rigor/rules/validate.h>
#include <rigor/text/diagnostic.h>

namespace rigor::tool {

class SelectionOptions {
 public:
  void declare(CLI::App& app);

  /// A UsageError when a value is none. Names of rules are left to `require_known`.
  rules::Selection selection() const;

  /// The level that `--fail-on` names; empty when it is not given.
  const std::string& fail_on() const { return fail_on_; }

 private:
  std::string fail_on_;
  std::vector<std::string> select_;
  std::vector<std::string> ignore_;
  std::vector<std::string> severity_;
  std::vector<std::string> targets_;
};

/// Of "error", "warning", "info" and "never", which is nothing. A UsageError for another word.
std::optional<Severity> fail_on_level(const std::string& name);

/// Every rule and every category, once.
std::vector<std::string_view> names_of_rules(const rules::Registry& registry);

/// A UsageError that names the first unknown rule or category, and what was probably meant.
void require_known(const rules::Selection& selection, const rules::Registry& registry);

}  // namespace rigor::tool
