// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::include_has_errors {

/// Whether the first error is of a mesh that is not found: `validate` names others before it.
bool is_about_meshes(const read::Fact& fact) {
  return fact.tried.front().starts_with("the mesh '");
}

void check(const read::Fact& fact, Context& context) {
  const bool one = fact.count == 1;
  std::vector<Label> first;
  if (!fact.related.nowhere()) first.push_back({fact.related, fact.tried.front()});
  context.report({.where = fact.where,
                  .message = "the included file '" + fact.name + "' has " +
                             (one ? "an error" : std::to_string(fact.count) + " errors") + ": " +
                             fact.tried.front() + (one ? "" : ", …"),
                  .of_file = fact.name,
                  .related = std::move(first),
                  .help = "check that file: rigor validate " + fact.name,
                  .cause = fact.name,
                  .why = is_about_meshes(fact) ? "Where this model is included, these parts are "
                                                 "missing as well."
                                               : ""});
}

Rule rule() {
  return {
      .name = "include-has-errors",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .summary = "an included file has errors of its own",
      .why = "A simulator that rejects or misreads the included file rejects or misreads this one "
             "with it: libsdformat reports the inner error and drops what was included.",
      .what_to_do =
          "Check the included file by itself and correct it there. Its findings are reported only "
          "then, so that one cause is not reported for every world that uses it.",
      .checks = {on_read({read::FactKind::kIncludeHasErrors}, check)},
  };
}

}  // namespace rigor::rules::include_has_errors
