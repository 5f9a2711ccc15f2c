// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Templates among the files of a run: each is expanded once, checked as the model that it became, and
// what is found there is told of the template.
//
//   ExpandedTemplates templates(environment, sources, workspace, options);
//   if (templates.takes(left_out)) templates.expand(left_out.path);
//   ...
//   if (templates.has(path)) found = templates.in_source(path, found);

#pragma once

#include <map>
#include <string>

#include <rigor/read/discover.h>
#include <rigor/read/expansion.h>
#include <rigor/read/workspace.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>
#include <rigor/text/diagnostic.h>
#include <rigor/text/sources.h>

namespace rigor::rules {

/// All that it is given outlives it. Looked into by any thread once all are expanded.
class ExpandedTemplates {
 public:
  ExpandedTemplates(const Environment& environment, Sources& sources, read::Workspace& workspace,
                    const ValidateOptions& options)
      : environment_(environment), sources_(sources), workspace_(workspace), options_(options) {}

  /// Only what is named: of a folder's templates nobody knows which are robots, and which only hold macros.
  bool takes(const read::LeftOut& left) const;

  /// The workspace has the model in place of the template then, if it became one. Not in another shard.
  void expand(const std::string& path);

  bool has(const std::string& path) const { return find(path) != nullptr; }

  /// Why the template became no model, as a fact to run rules over; null when it is no template or became one.
  const read::Expansion* failed(const std::string& path) const;

  /// Findings in what the template became, at their places in the template.
  Diagnostics in_source(const std::string& path, Diagnostics found) const;

 private:
  const read::Expansion* find(const std::string& path) const;

  const Environment& environment_;
  Sources& sources_;
  read::Workspace& workspace_;
  const ValidateOptions& options_;
  std::map<std::string, read::Expansion> expansions_;  // by normal path
};

}  // namespace rigor::rules
