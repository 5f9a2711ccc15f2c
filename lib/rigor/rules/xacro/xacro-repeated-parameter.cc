// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_repeated_parameter {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-repeated-parameter",
      .severity = Severity::kWarning,
      .summary = "a macro lists a parameter twice",
      .why = "Which of the two gets the value of a call depends on how xacro reads them; their "
             "defaults may differ.",
      .what_to_do = "Remove one of them.",
      .checks = {on_xacro({FactKind::kRepeatedParameter}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_repeated_parameter
