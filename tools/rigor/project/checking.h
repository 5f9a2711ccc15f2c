// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Checking files as `validate` does: with the project's configuration, the environment, and what earlier runs
// know of meshes.
//
//   Checking checking(arguments, disk);
//   checking.refuse_bad_settings();
//   const rules::ValidateResult result = checking.run(sources);
//   return checking.exit_code(result);

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <rigor/mass/mesh/facts.h>
#include <rigor/mass/mesh/reads.h>
#include <rigor/mass/mesh/survey.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>
#include <rigor/text/disk.h>

#include "option/compat_option.h"
#include "option/file_options.h"
#include "option/rule_settings.h"
#include "option/search.h"
#include "option/selection.h"
#include "option/shard_option.h"
#include "project/cache.h"
#include "project/changed_since.h"

namespace rigor::tool {

/// What the command line says of it.
struct CheckArguments {
  std::vector<std::string> paths;  ///< `-` is stdin; none is `.`
  std::string stdin_filename;
  SelectionOptions selection;
  CompatOption compat;
  FileOptions files;
  ChangedSinceOption changed_since;
  bool no_mesh = false;
  bool all_arguments = false;  ///< of templates
  unsigned jobs = 0;
  ShardOption shard;
  CacheOption cache;
  SearchOptions search;

  /// What rigor is asked to look at, stdin by its file's name.
  std::vector<std::string> named() const;
};

/// What checking takes, on a disk: made once for all that is done with it. Both arguments outlive it.
class Checking {
 public:
  Checking(const CheckArguments& a, const Disk& disk);
  Checking(const Checking&) = delete;
  Checking& operator=(const Checking&) = delete;

  const Environment& environment() const { return environment_; }
  const RuleSettings& settings() const { return settings_; }
  rules::ValidateOptions& options() { return options_; }

  /// What is known of meshes, for whoever asks for more than rules do.
  mass::MeshReads& reads() { return reads_; }
  mass::MeshSurveys& surveys() { return surveys_; }
  /// Of all threads that ask for them.
  Turns& turns() { return turns_; }

  /// Before anything else asks the configurations: a UsageError that tells of all that is wrong in one.
  void refuse_bad_settings() const;

  rules::ValidateResult run(Sources& sources) const;

  /// Of the result's findings, and of arguments that could not be used.
  int exit_code(const rules::ValidateResult& result) const;

  /// That `--changed-since` left no file, when it did.
  std::optional<std::string> nothing_changed() const;

 private:
  void choose_files(const Disk& disk);

  const CheckArguments& arguments_;
  Environment environment_;
  Reach reach_;
  RuleSettings settings_;
  std::optional<ChangedFiles> changed_;
  std::optional<mass::MeshCache> cache_;
  Turns turns_;
  mass::MeshReads reads_;
  mass::MeshSurveys surveys_;
  mass::MeshFiles mesh_files_;
  rules::ValidateOptions options_;
};

}  // namespace rigor::tool
