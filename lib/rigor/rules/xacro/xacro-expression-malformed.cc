// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_expression_malformed {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-expression-malformed",
      .severity = Severity::kError,
      .summary = "an expression is no expression of xacro",
      .why = "xacro evaluates `${…}` as Python, and ends where Python does. What rigor does not "
             "evaluate of Python (lambda, formatted strings, names with a double underscore) is "
             "not evaluated everywhere either.",
      .what_to_do = "Correct the expression. A dollar sign before a brace is written `$$`.",
      .checks = {on_xacro({FactKind::kSyntax, FactKind::kBadText, FactKind::kOutsideLanguage},
                          report_fact)},
  };
}

}  // namespace rigor::rules::xacro_expression_malformed
