// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which branches of a template its expansions took.
//
//   TemplateBranches branches;
//   branches.add(expansion);                       // of each set of arguments
//   std::vector<xacro::Fact> facts = branches.dead(sources);

#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include <rigor/text/sources.h>
#include <rigor/xacro/expand.h>
#include <rigor/xacro/fact.h>

namespace rigor::rules {

class TemplateBranches {
 public:
  /// Those of the template itself. What it includes may be for other robots, too.
  void add(const xacro::Expansion& expansion);

  /// Conditions that were false whenever they were evaluated, but for those that no single argument
  /// decides: a set gives a value to one argument.
  std::vector<xacro::Fact> dead(const Sources& sources) const;

  bool has_skipped() const { return !skipped_.empty(); }

 private:
  std::map<std::uint32_t, Span>
      skipped_;  ///< by the offset of the tag, as the first expansion read it
  std::set<std::uint32_t> taken_;
};

}  // namespace rigor::rules
