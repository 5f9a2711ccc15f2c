// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_missing_prefix {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-missing-prefix",
      .severity = Severity::kWarning,
      .summary = "an element is written like the call of a macro, without xacro:",
      .why = "Releases before Jade took it for a call. Now it stays in the result as an element "
             "that no consumer knows, and what the macro makes is missing.",
      .what_to_do = "Write `<xacro:NAME …/>`.",
      .checks = {on_xacro({FactKind::kMissingPrefix}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_missing_prefix
