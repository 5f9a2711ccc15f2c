// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is wrong with the comments of a file that suppress findings; see suppression.h.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <rigor/text/edit.h>
#include <rigor/text/span.h>

namespace rigor::rules {

enum class SuppressionFactKind : std::uint8_t {
  kUnused,        ///< no finding of that rule is covered
  kUnknownRule,   ///< no rule has that name
  kMalformed,     ///< what follows `rigor:` is nothing that a comment can say
  kNoElement,     ///< nothing follows that it could cover
  kNoNames,       ///< no rules are named
  kUnclosedList,  ///< the list of names has no `]`
  kEveryRule,     ///< `all`, where names are wanted
  kMisplaced,     ///< `file-ignore` behind the root's start
};

struct SuppressionFact {
  SuppressionFactKind kind;
  Span where;               ///< the rule's name in the comment; the comment where it has none
  std::string name;         ///< the rule as written; else the word that follows `rigor:`
  std::vector<Edit> edits;  ///< that take the name, or the whole comment, away
  std::vector<std::string> near = {};  ///< names that may have been meant
};

using SuppressionFacts = std::vector<SuppressionFact>;

}  // namespace rigor::rules
