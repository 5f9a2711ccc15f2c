// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_deprecated {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-deprecated",
      .severity = Severity::kInfo,
      .summary = "a deprecated form of xacro",
      .why = "xacro prints a warning for it, and a later release will refuse it.",
      .what_to_do = "Write the form that the message names.",
      .checks = {on_xacro({FactKind::kDeprecatedFunction, FactKind::kDeprecatedMacroName},
                          report_fact)},
  };
}

}  // namespace rigor::rules::xacro_deprecated
