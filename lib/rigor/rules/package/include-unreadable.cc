// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::include_unreadable {

void check(const read::Fact& fact, Context& context) {
  context.report(
      {.where = fact.where, .message = "the included file cannot be read: " + fact.name});
}

Rule rule() {
  return {
      .name = "include-unreadable",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .summary = "an included file cannot be read",
      .why = "libsdformat refuses the whole file; Gazebo leaves the model out.",
      .what_to_do = "Put the included file right: checking it tells more.",
      .checks = {on_read({read::FactKind::kIncludeUnreadable}, check)},
  };
}

}  // namespace rigor::rules::include_unreadable
