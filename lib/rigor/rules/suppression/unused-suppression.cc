// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string_view>
#include <utility>

#include <rigor/rules/rule.h>
#include <rigor/rules/suppression_fact.h>

namespace rigor::rules::unused_suppression {

bool is_whole_comment(const Edit& edit, const Context& context) {
  return context.bytes(edit.span).find("<!--") != std::string_view::npos;
}

void check(const SuppressionFact& fact, Context& context) {
  Finding finding{.where = fact.where};
  finding.message = fact.kind == SuppressionFactKind::kNoElement
                        ? "no element follows that this comment could cover"
                        : "no finding of '" + fact.name + "' is hidden by this comment";
  if (!fact.edits.empty()) {
    const bool whole = is_whole_comment(fact.edits.front(), context);
    finding.fix =
        Fix{whole ? "remove the comment" : "remove the name", Applicability::kSafe, fact.edits};
  }
  context.report(std::move(finding));
}

Rule rule() {
  return {
      .name = "unused-suppression",
      .severity = Severity::kWarning,
      .fix = FixGrade::kSafe,
      .summary = "a comment suppresses findings that are not there",
      .why = "What it was written for has been put right, or has moved. Left in place it hides the "
             "same fault when that comes back, and tells readers of one that is gone.",
      .what_to_do =
          "Remove the name, or the comment when it was the only one. An `ignore` covers the "
          "element that follows it among its siblings: move it if it was meant for another.",
      .checks = {on_suppression({SuppressionFactKind::kUnused, SuppressionFactKind::kNoElement},
                                check)},
  };
}

}  // namespace rigor::rules::unused_suppression
