// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::xacro_failed {

void check(const read::Fact& fact, Context& context) {
  context.report({.message = "xacro cannot expand the file: " + fact.name});
}

// A test shows it, with a program of its own; no example can.
Rule rule() {
  return {
      .name = "xacro-failed",
      .severity = Severity::kError,
      .summary = "xacro cannot expand the file",
      .why = "Launch files run xacro before anything reads the robot: what it refuses, none of "
             "them loads. An undefined property or macro, an argument without a default, or a "
             "package that is not found is behind most of it.",
      .what_to_do = "Run xacro on the file by hand and put right what it says. A file that needs "
                    "arguments (or holds only macros, for others to include) is checked by what "
                    "includes it: name that one.",
      .checks = {on_read({read::FactKind::kXacroFailed}, check)},
  };
}

}  // namespace rigor::rules::xacro_failed
