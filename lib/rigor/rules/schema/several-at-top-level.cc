// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::several_at_top_level {

void check(const read::Fact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "a second <" + fact.name +
                             "> at the top: a file holds one model, "
                             "actor or light"});
}

Rule rule() {
  return {
      .name = "several-at-top-level",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .formats = Formats::kSdf,
      .summary = "a file has more than one model, actor or light at its top",
      .why = "libsdformat takes the first and reports an error for the rest.",
      .what_to_do = "Put the others into files of their own, or all of them into a <world>.",
      .checks = {on_read({read::FactKind::kMoreAtTopLevel}, check)},
  };
}

}  // namespace rigor::rules::several_at_top_level
