// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `--fix`, `--unsafe-fixes` and `--diff`: what a check found is put right in the files, or shown as a diff.
//
//   if (fix_.asked()) changed = fix_.run(environment, options, result, sources);
//   if (fix_.asked() && !fix_.diff() && changed) result = validate(environment, options, sources);
//   fix_.hint(result.diagnostics);

#pragma once

#include <string_view>

#include <CLI/CLI.hpp>

#include <rigor/author/fix.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>
#include <rigor/text/diagnostic.h>
#include <rigor/text/sources.h>
#include "output/output.h"

namespace rigor::tool {

class FixOptions {
 public:
  void declare(CLI::App& app);

  bool asked() const { return fix_ || diff_; }
  /// Only the diff is wanted: then nothing is written, `--fix` or not, and findings are not listed.
  bool diff() const { return diff_; }

  /// Prints the diff; or writes the files, each whole or not at all, and prints what stdin held, fixed:
  /// `options.buffer` holds that then. Says on stderr what was fixed, and what was left and why. Whether
  /// anything is other than it was. A UsageError when a file cannot be written; the others are.
  bool run(const Environment& environment, rules::ValidateOptions& options,
           const rules::ValidateResult& result, const Sources& sources) const;

  /// As tool::write; but what stdin held is on stdout when it was fixed, so findings go to stderr.
  void write(const Target& target, std::string_view text,
             const rules::ValidateOptions& options) const;

  /// Says on stderr which options would fix how many of the findings; nothing when none would.
  void hint(const Diagnostics& findings) const;

 private:
  Applicability most() const { return unsafe_ ? Applicability::kUnsafe : Applicability::kSafe; }

  bool fix_ = false;
  bool unsafe_ = false;
  bool diff_ = false;
};

}  // namespace rigor::tool
