// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::file_unreadable {

void check(const read::Fact& fact, Context& context) {
  context.report({.where = fact.where, .message = "the file cannot be read: " + fact.name});
}

Rule rule() {
  return {
      .name = "file-unreadable",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways, .urdf = Refusal::kAlways},
      .summary = "a file cannot be read",
      .why = "Nothing is known of it, and no simulator can load it either.",
      .what_to_do = "Look at its permissions, and whether it is a broken link.",
      .checks = {on_read({read::FactKind::kFileUnreadable}, check)},
  };
}

}  // namespace rigor::rules::file_unreadable
