// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_constant_condition {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-constant-condition",
      .severity = Severity::kInfo,
      .summary = "a condition is always true, or always false",
      .why = "No argument and no property decides it, so one branch is dead in every robot that "
             "is made.",
      .what_to_do = "Remove the condition, and what is never used; or let an argument decide.",
      .checks = {on_xacro({FactKind::kConstantCondition}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_constant_condition
