// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which rules run, how severe they are, and which findings make the exit code 1: `--select`,
// `--ignore`, `--severity`, `--fail-on`.

#pragma once

#include <string>
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

  /// Whether any is at or above the level of `--fail-on`.
  bool fails(const Diagnostics& diagnostics) const;

 private:
  std::string fail_on_ = "error";
  std::vector<std::string> select_;
  std::vector<std::string> ignore_;
  std::vector<std::string> severity_;
};

/// A UsageError that names the first unknown rule or category, and what was probably meant.
void require_known(const rules::Selection& selection, const rules::Registry& registry);

}  // namespace rigor::tool
