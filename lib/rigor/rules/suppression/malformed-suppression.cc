// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/rule.h>
#include <rigor/rules/suppression/suppression_comment.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules::malformed_suppression {

using Kind = SuppressionFactKind;

std::string message(const SuppressionFact& fact) {
  switch (fact.kind) {
    case Kind::kNoNames: return "'" + fact.name + "' names no rules";
    case Kind::kUnclosedList: return "the list of names after '" + fact.name + "' has no ']'";
    case Kind::kEveryRule:
      return "'" + fact.name + "' is no name, and not everything can be ignored";
    case Kind::kMisplaced: return "'file-ignore' is after the start of the root element";
    default: break;
  }
  if (fact.name.empty()) return "nothing follows 'rigor:'";
  return "'" + fact.name + "' is not a directive of rigor comments";
}

std::string help(const SuppressionFact& fact) {
  if (fact.kind == Kind::kMisplaced) {
    return "move it before the root element, or write 'ignore' for the next element";
  }
  if (fact.kind != Kind::kMalformed) {
    const std::string word = fact.kind == Kind::kEveryRule ? "ignore" : fact.name;
    return "write the names of rules or categories in brackets: " + word + "[axis-zero, mesh] why";
  }
  const auto near = schema::near(fact.name, suppression_forms());
  if (!near.empty()) return "did you mean '" + std::string(near.front()) + "'?";
  return "write ignore[…], ignore-next[…] or file-ignore[…]; or begin with another word when it is "
         "not meant for rigor";
}

void check(const SuppressionFact& fact, Context& context) {
  context.report({.where = fact.where, .message = message(fact), .help = help(fact)});
}

Rule rule() {
  return {
      .name = "malformed-suppression",
      .severity = Severity::kWarning,
      .summary = "malformed suppression comment",
      .why = "It looks as if something were ignored, and nothing is. Everything at once cannot be "
             "ignored: then a new fault would go unseen with the known ones.",
      .what_to_do =
          "Write `<!-- rigor: ignore[rule, category] why -->` before the element that it is for, "
          "`ignore-next[…]` for its start tag alone, or `file-ignore[…]` before the root.",
      .checks = {on_suppression({Kind::kMalformed, Kind::kNoNames, Kind::kUnclosedList,
                                 Kind::kEveryRule, Kind::kMisplaced},
                                check)},
  };
}

}  // namespace rigor::rules::malformed_suppression
