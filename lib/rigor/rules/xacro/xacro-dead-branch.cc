// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_dead_branch {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-dead-branch",
      .severity = Severity::kInfo,
      .summary = "a branch that no set of arguments takes",
      .why = "With --xacro-args all each argument takes every value that a condition compares it "
             "with, and the condition was false each time. The branch is for a value that cannot "
             "occur, or that is misspelled.",
      .what_to_do = "Correct the value that the condition compares with, or remove the branch.",
      .checks = {on_xacro({FactKind::kDeadBranch}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_dead_branch
