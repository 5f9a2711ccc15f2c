// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::file_too_large {

void check(const read::Fact& fact, Context& context) {
  context.report({.where = fact.where, .message = "the file cannot be read: " + fact.name});
}

Rule rule() {
  return {
      .name = "file-too-large",
      .severity = Severity::kError,
      .summary = "a file is larger than any model is",
      .why = "Reading it would take some twenty times its size in memory; it is not checked. The "
             "largest known world has 3 MB, the bound is 64 MiB.",
      .what_to_do = "Split the file and include its parts; or look whether it is a mesh or a log.",
      .checks = {on_read({read::FactKind::kFileTooLarge}, check)},
  };
}

}  // namespace rigor::rules::file_too_large
