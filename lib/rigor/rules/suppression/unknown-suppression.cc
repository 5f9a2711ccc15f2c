// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <utility>

#include <rigor/rules/rule.h>
#include <rigor/rules/suppression_fact.h>

namespace rigor::rules::unknown_suppression {

void check(const SuppressionFact& fact, Context& context) {
  Finding finding{.where = fact.where};
  finding.message = "no rule or category is called '" + fact.name + "'";
  for (const std::string& near : fact.near) {
    finding.help += (finding.help.empty() ? "did you mean '" : "' or '") + near;
  }
  if (!finding.help.empty()) {
    finding.help += "'?";
  } else {
    finding.help = fact.name.find_first_of(" \t\r\n") == std::string::npos
                       ? "`rigor rules` lists the names"
                       : "put commas between names";
  }
  context.report(std::move(finding));
}

Rule rule() {
  return {
      .name = "unknown-suppression",
      .severity = Severity::kWarning,
      .summary = "a comment suppresses a rule that does not exist",
      .why = "The name is misspelt, or its rule is gone: the comment has no effect.",
      .what_to_do = "Write the name as `rigor rules` lists it, or remove it.",
      .checks = {on_suppression({SuppressionFactKind::kUnknownRule}, check)},
  };
}

}  // namespace rigor::rules::unknown_suppression
