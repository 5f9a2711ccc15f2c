// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_include_matches_nothing {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-include-matches-nothing",
      .severity = Severity::kWarning,
      .summary = "the pattern of an include matches no file",
      .why = "xacro prints a warning and goes on without. What the files were to define is "
             "missing.",
      .what_to_do = "Correct the pattern, or remove the include.",
      .checks = {on_xacro({FactKind::kNoMatch}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_include_matches_nothing
