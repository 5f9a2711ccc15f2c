// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::include_too_large {

void check(const read::Fact& fact, Context& context) {
  const bool deep = fact.kind == read::FactKind::kIncludeTooDeep;
  context.report({.where = fact.where,
                  .message = deep ? "includes are nested deeper than 32 levels here"
                                  : "with this the file's includes bring more than 200,000 parts: "
                                    "it is not read to its end"});
}

Rule rule() {
  return {
      .name = "include-too-large",
      .severity = Severity::kError,
      .summary = "the includes are nested too deep, or bring more than rigor holds",
      .why = "No robot needs 32 levels of includes or 200,000 parts; a simulator will run out of "
             "memory or time. What lies beyond is not checked.",
      .what_to_do = "Look for an include that multiplies itself.",
      .checks = {on_read({read::FactKind::kTooMuchIncluded, read::FactKind::kIncludeTooDeep},
                         check)},
  };
}

}  // namespace rigor::rules::include_too_large
