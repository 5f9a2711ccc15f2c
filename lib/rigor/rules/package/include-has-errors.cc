// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::include_has_errors {

void check(const read::Fact& fact, Context& context) {
  const bool one = fact.count == 1;
  std::vector<Label> first;
  if (!fact.related.nowhere()) first.push_back({fact.related, fact.tried.front()});
  context.report({.where = fact.where,
                  .message = "the included file '" + fact.name + "' has " +
                             (one ? "an error" : std::to_string(fact.count) + " errors") + ": " +
                             fact.tried.front() + (one ? "" : ", …"),
                  .related = std::move(first),
                  .help = "check that file: rigor validate " + fact.name});
}

Rule rule() {
  return {
      .name = "include-has-errors",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .summary = "an included file has errors of its own",
      .why = "A simulator that refuses or misreads the included file refuses or misreads this one "
             "with it: libsdformat reports the inner error and drops what was included.",
      .what_to_do =
          "Check the included file by itself and put it right there. What is wrong inside it is "
          "told only then, so that one fault is not told by every world that uses it.",
      .checks = {on_read({read::FactKind::kIncludeHasErrors}, check)},
  };
}

}  // namespace rigor::rules::include_has_errors
