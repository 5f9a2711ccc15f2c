// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which rules run over a file, how severe they are and which findings fail: what the command line says
// and, under it, what the configuration for that file does.
//
//   const RuleSettings settings(selection_, search_.config(), environment.registry);
//   options.selection_for = [&](const std::string& path) { return settings.selection(path); };
//   const rules::ValidateResult result = rules::validate(environment, options, sources);
//   return settings.fails(result) ? kFindings : kClean;
//
// `--select`, `--target` and `--fail-on` take the place of the configuration's; `--ignore` and
// `--severity` come on top. A name that `--select` gives itself is not ignored because the configuration
// says so.

#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <rigor/config/config.h>
#include <rigor/rules/registry.h>
#include <rigor/rules/validate.h>

#include "option/selection.h"
#include "project/config_file.h"

namespace rigor::tool {

/// A value, and who says it: an option, a place in a configuration, or nobody.
struct Said {
  std::string value;
  std::string option = {};  ///< "--ignore"
  config::Place place = {};
};

/// All that was said of one file.
struct SaidOfFile {
  std::vector<Said> select;  ///< all when empty
  std::vector<Said> ignore;
  std::vector<Said> targets;
  std::map<std::string, Said> severity;  ///< "error", "warning", "info", "off" by rule
  Said fail_on;
};

class RuleSettings {
 public:
  /// A UsageError when the command line names a rule, level or target that there is not. All three live
  /// longer than this.
  RuleSettings(const SelectionOptions& options, const ConfigOptions& config,
               const rules::Registry& registry);

  /// A UsageError that tells of all that cannot stand in the file's configuration, names of rules among
  /// it. For use by one thread.
  SaidOfFile said(const std::string& path) const;
  rules::Selection selection(const std::string& path) const;
  /// For a command with rules of its own, as a simulation's: what a configuration selects and targets is for
  /// `validate`, and left out.
  rules::Selection selection_of_command(const std::string& path) const;

  /// Whether any finding is at or above the level of its own file.
  bool fails(const rules::ValidateResult& result) const;
  /// The least severity that fails the run, of a file; nothing when none does.
  std::optional<Severity> fail_on(const std::string& path) const;
  bool fails(const std::string& path, Severity severity) const;

  /// The same of what another command found about one file.
  bool fails(const std::string& path, const Diagnostics& found) const;

 private:
  const config::Config& sound(const std::string& path) const;
  std::vector<config::Problem> unknown_names(const config::Config& config) const;

  const SelectionOptions& options_;
  const ConfigOptions& config_;
  const rules::Registry& registry_;
  rules::Selection given_;  ///< of the command line
  mutable std::set<const config::Config*> sound_;
};

}  // namespace rigor::tool
