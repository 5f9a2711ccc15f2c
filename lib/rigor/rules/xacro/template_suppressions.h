// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The comments of a template and of what it includes that suppress findings, over all of its expansions.
//
//   TemplateSuppressions suppressions(sources);
//   found = suppressions.uncovered(std::move(found), expansion);   // of each set of arguments
//   SuppressionFacts unused = suppressions.facts(registry, runner, meshes);

#pragma once

#include <optional>

#include <rigor/rules/suppression.h>
#include <rigor/text/diagnostic.h>
#include <rigor/text/sources.h>
#include <rigor/xacro/expand.h>

namespace rigor::rules {

class TemplateSuppressions {
 public:
  explicit TemplateSuppressions(const Sources& sources) : sources_(sources) {}

  /// Without those that comments cover in the files that they are in. What `file-ignore` says in the
  /// template itself holds for all of its findings, in an included file for that file's.
  Diagnostics uncovered(Diagnostics found, const xacro::Expansion& expansion);

  /// Of `all`, the copies of comments in the expanded model left `left`: what they covered was not
  /// suppressed in vain.
  void count_copies(const Diagnostics& all, const Diagnostics& left);

  /// What is wrong with the template's own comments, when all findings went through `uncovered`. Those in
  /// included files are for others, too.
  SuppressionFacts facts(const Registry& registry, const Runner& runner, MeshPolicy meshes) const;

 private:
  const Sources& sources_;
  std::optional<Suppressions> own_;
};

}  // namespace rigor::rules
