// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Findings that are known and hidden: `--baseline`, `--baseline-write`, `--baseline-prune`,
// `--baseline-strict`.
//
//   baseline_.read(disk);  // before the run, so that a wrong file is told at once
//   result = baseline_.apply(environment, options, std::move(result));
//   baseline_.conclude();
//   if (baseline_.fails()) return kFindings;

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <rigor/rules/baseline.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>
#include <rigor/text/disk.h>

namespace rigor::tool {

class BaselineOptions {
 public:
  void declare(CLI::App& app);

  /// Where no option names a file, the configuration's. A UsageError when options contradict each other, or
  /// the file is not there or is none.
  void read(const Disk& disk, const std::optional<std::string>& configured = std::nullopt);

  /// What the baseline leaves; all of it where none is asked for. Writes the file when it is to be written,
  /// which it is not when an argument could not be used.
  rules::ValidateResult apply(const Environment& environment, const rules::ValidateOptions& options,
                              rules::ValidateResult result);

  /// Says on stderr what was hidden or written.
  void conclude() const;

  /// Whether `--baseline-strict` finds that the file counts more than there is.
  bool fails() const { return strict_ && stale_; }

 private:
  rules::BaselinePlace place() const;
  const std::string& path() const { return write_.empty() ? path_ : write_; }
  void keep(rules::Baseline next);
  void write(const std::string& text) const;
  void tell_stale(const std::vector<rules::StaleBaseline>& stale);

  std::string path_;
  std::string write_;
  bool prune_ = false;
  bool strict_ = false;
  bool there_ = false;       ///< the file was
  bool configured_ = false;  ///< a repository names it, not who runs rigor
  bool stale_ = false;
  rules::Baseline baseline_;
  std::vector<std::string> told_;
};

}  // namespace rigor::tool
